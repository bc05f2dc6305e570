#pragma once
#include <Eigen/Core>

#include "geometry/planar/region.h"

namespace blossom::minkowski {

/// How a control shape stands in a morph: scaled and turned about its centre (control_centre.h), then moved.
struct Placement {
  double scale = 1;            ///< above 0
  double turn = 0;             ///< degrees, counter-clockwise
  Vec2 offset = Vec2::Zero();  ///< mm
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// The map of a placement about a centre. Quarters of a turn are exact, and nothing else than an offset adds just that.
Eigen::Matrix<double, 2, 3> affineOf(const Placement&, const Vec2& centre);

/// The region where it stands, arcs as arcs; with a placement that changes nothing the region itself, bit for bit.
/// @throws Error InvalidParameter when the scale is not positive or a number is not finite.
Region placed(const Region&, const Placement&);

}  // namespace blossom::minkowski
