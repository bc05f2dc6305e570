#pragma once
#include "kernel/solid/blend.h"

namespace blossom::modeling {

struct FilletOptions {
  double radius = 2;
  std::vector<int> edges;  ///< numbers (geometry/occt/sub_shape.h); none: all sharp edges
};
using FilletResult = BlendResult;

/// Rounds edges of a solid with a rolling ball. @throws Error as blend.
FilletResult fillet(const TopoDS_Shape&, const FilletOptions&, const Progress& = Progress::none());

struct ChamferOptions {
  double distance = 2;     ///< mm from the edge along both faces
  double second = 0;       ///< mm along the second face; 0: equal to `distance`
  std::vector<int> edges;  ///< numbers; none: all sharp edges
};
using ChamferResult = BlendResult;

/// Bevels edges of a solid. @throws Error as blend.
ChamferResult chamfer(const TopoDS_Shape&, const ChamferOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
