#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

/// A warning for open surfaces that cut through themselves (geometry/crossing/surface_crossing.h): as surfaces they are
/// valid, and nothing else tells. With place and depth.
/// @param why cause and remedy, as sentences
void warnOfCrossing(const std::vector<TopoDS_Shape>& sheets, const std::string& why, std::vector<std::string>& warnings,
                    const Progress&);

/// A warning for solids of which two hold the same space (geometry/crossing/part_overlap.h), so that their volumes add up to
/// more than they fill. Every solid is compared with the ones named alone, which is enough for copies in rows and rings.
void warnOfOverlap(const std::vector<TopoDS_Shape>& solids, const std::vector<std::size_t>& compared,
                   std::vector<std::string>& warnings, const Progress&);

}  // namespace blossom::modeling
