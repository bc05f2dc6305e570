#pragma once
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::modeling {

/// Closed outlines in one plane of space.
struct FlatOutlines {
  Curves drawing;  ///< in the plane's own coordinates
  gp_Trsf place;   ///< from there to space; a translation along z when the plane is horizontal
};

struct WireOutlines {
  std::vector<FlatOutlines> outlines;
  TopoDS_Shape others;  ///< faces, and wires that are open or not flat; null when there are none
};

/// Separates the edges and wires of a file: those that close in a plane are drawings of closed outlines.
WireOutlines wireOutlines(const TopoDS_Shape&);

}  // namespace blossom::modeling
