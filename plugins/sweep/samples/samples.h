#pragma once
#include <numbers>

#include "geometry/shape/motion.h"
#include "kernel/begin/turning_spline.h"

namespace blossom::sweep::samples {

Motion cylinder();     ///< radius 10, height 40
Motion torus();        ///< radii 30 and 10
Motion helicoid();     ///< two turns, pitch 20, radius 25
Motion twistedTube();  ///< three lobes, twisted by half a turn along a bend
Motion horn();         ///< a shell: a section along a spiral, growing with it
Motion propeller();    ///< Yoon & Lee 2009, Fig. 7: four blades out of a cylinder
Motion sweptPoint();   ///< Fig. 2: a point on the z axis of a frame that leans more and more

// Pieces that the motions are put together from.

/// Straight trajectory from `from` to `to` at even speed.
Curve straight(int degree, const std::vector<double>& knots, const Vec3& from, const Vec3& to);
/// Bicubic surface closed in u over `spans` even spans: pole (angle of the turn, Greville abscissa in v).
template <class Pole>
Surface closedBicubic(std::size_t spans, const std::vector<double>& knotsV, double sign, Pole pole) {
  std::vector<Vec4> poles;
  for (std::size_t i = 0; i < spans; ++i)
    for (const double v : grevilleAbscissae(3, knotsV))
      // Pole i of a cubic stands over break i - 1, so that u = 0 is the angle 0.
      poles.push_back(pole(2 * std::numbers::pi * (static_cast<double>(i) - 1) / static_cast<double>(spans), v));
  return unwrapped(3, 3, evenBreaks(spans), knotsV, std::move(poles), sign);
}

}  // namespace blossom::sweep::samples
