#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/booleans/region_boolean.h"

namespace blossom::modeling {

struct BooleanOptions {
  BooleanOperation operation = BooleanOperation::Union;
  double fuzzy = 0;      ///< mm within which faces and edges count as touching; 0: the tolerances of the shapes
  bool simplify = true;  ///< join faces on the same surface and edges on the same curve
};

struct BooleanResult {
  TopoDS_Shape shape;
  std::vector<std::string> warnings;
};

/// The union of all shapes, the first minus all others, or the intersection of all. The shapes are either solids or planar
/// faces in a common plane; they are not modified.
/// @throws Error InvalidInput (fewer than two, not solids), Degenerate (nothing is left, OCCT fails), Cancelled.
BooleanResult combine(const std::vector<TopoDS_Shape>&, const BooleanOptions&, const Progress& = Progress::none());

/// @throws Error Degenerate: what is said of a difference or an intersection that is empty
[[noreturn]] void refuseNothingLeft(BooleanOperation);

}  // namespace blossom::modeling
