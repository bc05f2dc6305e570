#pragma once
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

/// Closed outlines that lie in one plane of space.
struct FlatOutlines {
  Curves drawing;  ///< in the plane's own coordinates
  gp_Trsf place;   ///< from there into space; only shifted upwards when the plane is level
};

struct WireOutlines {
  std::vector<FlatOutlines> outlines;
  TopoDS_Shape others;  ///< faces, and wires that are open or not flat; null when there are none
};

/// What a file gives as edges and wires, told apart: those that close in a plane are drawings of closed outlines.
WireOutlines wireOutlines(const TopoDS_Shape&);

}  // namespace blossom::modeling
