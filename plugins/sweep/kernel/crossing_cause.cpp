#include "kernel/crossing_cause.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/bspline/bspline.h"
#include "kernel/edit/seam_v.h"
#include "kernel/grid/motion_point.h"

namespace blossom::sweep {

namespace {

/// Whether the path there bends to a radius that the section reaches. A motion that stands or only turns has no path.
bool bendsTightly(const Motion& motion, const Vec2& at) {
  constexpr int around = 32;
  constexpr double margin = 1.5;
  const auto [low, high] = motion.domainU();
  const auto [first, last] = motion.domainV();
  const double aside = 0.01 * (last - first), v = std::clamp(at.y(), first + aside, last - aside);
  const auto path = [&](double t) -> Vec3 { return point(motion.trajectory, t); };
  const Vec3 middle = path(v), back = path(v - aside) - middle, on = path(v + aside) - middle;
  double reach = 0;
  for (int k = 0; k < around; ++k)
    reach = std::max(reach, (evaluate(motion, low + (high - low) * k / around, v).point - middle).norm());
  if (on.norm() + back.norm() < 1e-4 * reach) return true;
  // The radius of the circle through three places is |on| |back| |on - back| / (2 |on x back|).
  return on.norm() * back.norm() * (on - back).norm() < 2 * margin * reach * on.cross(back).norm();
}

/// The middle of two parameters that are near each other, if need be across the seam of a ring.
double between(double a, double b, const std::pair<double, double>& domain) {
  const double length = domain.second - domain.first, middle = (a + b) / 2;
  if (std::abs(a - b) <= length / 2) return middle;
  return middle + (middle < domain.first + length / 2 ? length / 2 : -length / 2);
}

}  // namespace

CrossingCause causeOfCrossing(const Motion& motion, const Vec2& first, const Vec2& second) {
  const auto share = [](double a, double b, std::pair<double, double> domain, bool closed) {
    const double d = std::abs(a - b) / (domain.second - domain.first);
    return closed ? std::min(d, 1 - d) : d;
  };
  const double alongU = share(first.x(), second.x(), motion.domainU(), motion.closedU != ClosedU::No);
  const bool ring = joinedInV(motion).has_value();
  const double alongV = share(first.y(), second.y(), motion.domainV(), ring);
  constexpr double same = 0.02, beside = 0.3;
  if (alongV < same)
    return {fmt::format("the section at v = {:.3g} crosses itself.", between(first.y(), second.y(), motion.domainV())),
            "Even out its scaling and rotation along u."};
  const bool nearBend = alongV < beside || (alongU < same && (bendsTightly(motion, first) || bendsTightly(motion, second)));
  if (nearBend)
    return {"the motion bends or turns more tightly than its sections are wide.",
            "Make the sections smaller there, or the bend of the trajectory wider."};
  return {"two parts of the motion that are far apart along v pass through each other.",
          "Move the trajectory apart there, or make the sections smaller."};
}

}  // namespace blossom::sweep
