#pragma once
#include <Eigen/Geometry>

#include "geometry/bspline/bspline.h"
#include "support/motion_samples.h"
#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/grid/motion_point.h"

/// How far the copies of a motion's parts are from copies; for tests of the plugin sweep.
namespace blossom::test {

inline Vec3 anyVector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// The largest distance of x(place(u), v) - t from the copy of x(u, v) - t, as a share of the poles' size.
template <class Place>
double asymmetry(Random& random, const Motion& motion, const Eigen::Matrix3d& turn, Place place) {
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
    if (evaluate(motion.orientation, u, v).norm() < 0.05) continue;
    const Vec3 centre = blossom::point(motion.trajectory, v);
    const Vec3 copy = centre + turn * (sweep::evaluate(motion, u, v).point - centre);
    worst = std::max(worst, (sweep::evaluate(motion, place(u), v).point - copy).norm() / sizeOfPoles(motion, u, v));
  }
  return worst;
}

}  // namespace blossom::test
