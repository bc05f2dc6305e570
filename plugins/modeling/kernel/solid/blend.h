#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <vector>

#include "core/progress.h"

/// What fillet and chamfer have in common: edges by number, one size, and a search for the largest size where it fails.
namespace blossom::modeling {

/// The common part of fillet and chamfer: edges by number, one size, and a search for the largest size when it fails.
struct BlendResult {
  TopoDS_Shape shape;
  int edges = 0;  ///< number of edges
};

/// Words of the message "Edge 3 cannot be rounded with 12 mm".
struct BlendWords {
  const char* done;  ///< "rounded"
  const char* size;  ///< "radius"
};

/// One attempt with OCCT. On failure it throws Standard_Failure or returns a null shape.
using BlendAttempt = std::function<TopoDS_Shape(const TopoDS_Shape&, const std::vector<TopoDS_Edge>&, double size)>;

/// Blends edges by number (geometry/occt/sub_shape.h); without numbers every edge between two faces that meet at an angle.
/// @throws Error NotFound for a number that does not exist; InvalidInput for an edge that does not have two faces, is
/// smooth, or does not allow the size, with the largest size that works; Cancelled.
BlendResult blend(const TopoDS_Shape&, const std::vector<int>& edges, double size, const BlendWords&, const BlendAttempt&,
                  const Progress&);

}  // namespace blossom::modeling
