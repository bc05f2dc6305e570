#pragma once
#include <TopoDS_Solid.hxx>

#include "core/progress.h"
#include "geometry/bspline/surface.h"

/// The one part of this kernel that builds on OCCT.
namespace blossom::sweep {

/// How an end of a tube is closed.
enum class EndCap {
  None,    ///< none, because the ends meet: a torus
  Point,   ///< the end is a single point
  Planar,  ///< a planar face
  Edge,    ///< none, because the end is a straight edge, as that of a chisel
  Cone     ///< straight lines to the centre of an end that is not planar
};

struct SolidResult {
  TopoDS_Solid solid;
  EndCap start = EndCap::None, end = EndCap::None;
};

/// The solid inside a swept tube: a surface closed in u, and in v either closed or capped at both ends. Caps share their
/// edges with the surface, so there are no gaps. Faces are oriented outward; the solid is valid and closed (BRepCheck) and
/// its triangles do not intersect. Rows or columns of poles that are equal within 1e-9 of the size, or within the rounding
/// of coordinates far from the origin, are made equal. The side keeps the parameters of the surface, but for domains shorter
/// than 1e-6, which become longer by a power of two; where an end is an edge, it is cut along v into up to four faces.
/// @throws Error InvalidInput when the surface is not closed in u; Degenerate when the solid is invalid or intersects
/// itself, with the place; Cancelled.
SolidResult makeSolid(const Surface&, const Progress& = Progress::none());

}  // namespace blossom::sweep
