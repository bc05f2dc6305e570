#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/toolpath.h"
#include "parameter/parameter.h"

namespace blossom {

/// Options: post, decimals, unit, line numbers.
std::vector<ParameterSpec> gcodeWriteOptions();

/// The program of a toolpath. Arcs are written as G2 and G3 when they are still arcs after rounding (ends at equal distances
/// from the centre within 0.005 mm, and on the same side as before), else as lines within the resolution.
/// @throws Error InvalidInput when a move is not finite or cuts without a feed, Cancelled.
std::string gcodeText(const Toolpath&, const Value& options, const Progress& = Progress::none());
void writeGcode(const Toolpath&, const std::filesystem::path&, const Value& options, const Progress&);

}  // namespace blossom
