#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

enum class BooleanOperation { Union, Difference, Intersection };

struct BooleanOptions {
  BooleanOperation operation = BooleanOperation::Union;
  double fuzzy = 0;      ///< mm within which faces and edges count as touching; 0: as exact as the shapes are
  bool simplify = true;  ///< joins faces of one surface and edges of one curve
};

struct BooleanResult {
  TopoDS_Shape shape;
  std::vector<std::string> warnings;
};

/// Union of all, the first without all others, or what all have in common. All shapes are solids, or all flat faces in one
/// plane. The shapes given stay as they are.
/// @throws Error InvalidInput (fewer than two, not solids), Degenerate (nothing is left, OCCT fails), Cancelled.
BooleanResult combine(const std::vector<TopoDS_Shape>&, const BooleanOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
