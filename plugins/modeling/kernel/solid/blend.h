#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <vector>

#include "core/progress.h"

/// What fillet and chamfer have in common: edges by number, one size, and a search for the largest size where it fails.
namespace blossom::modeling {

struct BlendResult {
  TopoDS_Shape shape;
  int edges = 0;  ///< how many were asked for or found
};

/// The words of an error: "Edge 3 cannot be rounded with 12 mm".
struct BlendWords {
  const char* done;  ///< "rounded"
  const char* size;  ///< "radius"
};

/// One attempt with OCCT; it may throw Standard_Failure or give null when it fails.
using BlendAttempt = std::function<TopoDS_Shape(const TopoDS_Shape&, const std::vector<TopoDS_Edge>&, double size)>;

/// Edges by number (geometry/occt/sub_shape.h); none means every edge where two faces meet at an angle.
/// @throws Error NotFound for a number that does not exist; InvalidInput for an edge that has no two faces, is smooth, or
/// cannot take the size, with the largest size that would work; Cancelled.
BlendResult blend(const TopoDS_Shape&, const std::vector<int>& edges, double size, const BlendWords&, const BlendAttempt&,
                  const Progress&);

}  // namespace blossom::modeling
