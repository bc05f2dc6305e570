#pragma once
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>

#include "core/angle.h"
#include "core/vector.h"
#include "geometry/occt/occt_vector.h"

namespace blossom::modeling {

/// Placement of a primitive: its origin, the direction of its z axis and a turn about it.
struct Placement {
  Vec3 position{0, 0, 0};
  Vec3 axis{0, 0, 1};
  double turn = 0;  ///< degrees
};

gp_Pnt toPoint(const Vec3&);
/// @throws Error InvalidParameter for the zero vector; `what` is its name in the message ("axis").
gp_Dir toDirection(const Vec3&, const char* what);
/// The coordinate system of a placement. Its x axis is the world's x axis projected perpendicular to z (the world's y axis
/// where that vanishes), turned.
gp_Ax2 frameOf(const Placement&);

}  // namespace blossom::modeling
