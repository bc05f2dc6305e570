#include "manipulators/reachable_target.h"

#include <algorithm>

#include "geometry/bspline/bspline.h"
#include "kernel/grid/motion_point.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

// The trajectory takes a share t of the way from x to the target p, from c to c + t (p - x). What is left from there to p is
// (1 - t) (p - a) with a = (c - t x) / (1 - t): the others bring it to p as without t about a, at 1 / (1 - t) of the size.
Vec3 reachableTarget(const Motion& motion, const MotionPlace& at, const PullWeights& weights, const Vec3& wanted) {
  const bool turns = weights.rotate > 0, scales = weights.scale > 0;
  if (turns == scales || weights.translate >= 1) return wanted;
  const double left = 1 - weights.translate;
  const Vec3 centre = point(motion.trajectory, at.v), x = evaluate(motion, at.u, at.v).point;
  const Vec3 about = (centre - weights.translate * x) / left, arm = wanted - about;
  if (turns) {
    const double radius = (x - centre).norm() / left;
    return arm.norm() > 0 ? Vec3(about + radius / arm.norm() * arm) : wanted;
  }
  const Vec4 r = evaluate(motion.orientation, at.u, at.v);
  if (!(r.squaredNorm() > 0)) return wanted;
  Vec3 inFrame = turnedBack(r, arm);
  constexpr double noComponent = 1e-9;  // as in kernel/edit/pull.cpp
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(motion.point[k]) <= noComponent * motion.point.cwiseAbs().maxCoeff()) inFrame[k] = 0;
  return about + turnedBack(conjugate(r), inFrame);
}

}  // namespace blossom::sweep
