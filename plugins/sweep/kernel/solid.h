#pragma once
#include <TopoDS_Solid.hxx>

#include "core/progress.h"
#include "geometry/bspline/surface.h"

/// The one part of this kernel that builds on OCCT.
namespace blossom::sweep {

/// How an end of a tube is shut.
enum class EndCap {
  None,    ///< the ends meet: a torus
  Point,   ///< the end runs into a point
  Planar,  ///< a plane
  Cone     ///< the end is not planar: straight lines to its centre
};

struct SolidResult {
  TopoDS_Solid solid;
  EndCap start = EndCap::None, end = EndCap::None;
};

/// The body inside a swept tube: a surface that closes in u, shut at both ends in v or closed there too. Caps are bounded by
/// the very edges of the surface, so the seams hold exactly. Faces look outward; BRepCheck finds the solid valid and closed,
/// and its triangles do not cross each other. Rows or columns of poles that agree within 1e-9 of the size count as the same
/// and are made so.
/// @throws Error InvalidInput when the surface does not close in u; Degenerate when no valid solid comes out or it
/// crosses itself, with the place; Cancelled.
SolidResult makeSolid(const Surface&, const Progress& = Progress::none());

}  // namespace blossom::sweep
