#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

struct LoftOptions {
  bool ruled = false;  ///< ruled surfaces between neighbours instead of a smooth surface through all
  bool solid = true;   ///< closed at both ends; needs closed sections
};

struct LoftResult {
  TopoDS_Shape shape;
  std::vector<std::string> warnings;  ///< where a sheet cuts through itself
};

/// The surface through two or more sections in their order: faces (with holes, if all have equally many), wires, and single
/// points at the ends. Sections with different numbers of corners are matched by length.
/// @throws Error InvalidInput that names the section, Degenerate, Cancelled.
LoftResult loft(const std::vector<TopoDS_Shape>& sections, const LoftOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
