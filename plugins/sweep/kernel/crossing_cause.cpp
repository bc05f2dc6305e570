#include "kernel/crossing_cause.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "kernel/edit/seam_v.h"
#include "kernel/grid/motion_point.h"

namespace blossom::sweep {

namespace {

/// How far the section at v reaches from the trajectory.
double reachAt(const Motion& motion, double v) {
  constexpr int around = 32;
  const auto [low, high] = motion.domainU();
  const Vec3 middle = point(motion.trajectory, v);
  double reach = 0;
  for (int k = 0; k < around; ++k)
    reach = std::max(reach, (evaluate(motion, low + (high - low) * k / around, v).point - middle).norm());
  return reach;
}

/// Whether the path there bends to a radius that the section reaches. A motion that stands or only turns has no path.
bool bendsTightly(const Motion& motion, double at) {
  constexpr double margin = 1.5;
  const auto [first, last] = motion.domainV();
  const double aside = 0.01 * (last - first), v = std::clamp(at, first + aside, last - aside);
  const auto path = [&](double t) -> Vec3 { return point(motion.trajectory, t); };
  const Vec3 middle = path(v), back = path(v - aside) - middle, on = path(v + aside) - middle;
  const double reach = reachAt(motion, v);
  if (on.norm() + back.norm() < 1e-4 * reach) return true;
  // The radius of the circle through three places is |on| |back| |on - back| / (2 |on x back|).
  return on.norm() * back.norm() * (on - back).norm() < 2 * margin * reach * on.cross(back).norm();
}

/// Places along v from one to another, through the seam of a ring where that is shorter.
std::vector<double> placesBetween(double a, double b, const std::pair<double, double>& domain, bool ring) {
  constexpr int count = 64;
  const double length = domain.second - domain.first;
  double way = b - a;
  if (ring && std::abs(way) > length / 2) way += way > 0 ? -length : length;
  std::vector<double> places;
  places.reserve(count + 1);
  for (int k = 0; k <= count; ++k) {
    double v = a + way * k / count;
    if (v > domain.second) v -= length;
    if (v < domain.first) v += length;
    places.push_back(v);
  }
  return places;
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
  const std::vector<double> places = placesBetween(first.y(), second.y(), motion.domainV(), ring);
  double way = 0;  // along the path
  for (std::size_t k = 1; k < places.size(); ++k)
    way += (point(motion.trajectory, places[k]) - point(motion.trajectory, places[k - 1])).norm();
  const double reach = std::max(reachAt(motion, first.y()), reachAt(motion, second.y()));
  constexpr double same = 0.02, little = 0.5, around = 3.2;  // of the domain; of the reach: half a turn about it
  if (alongV < same && way < little * reach)
    return {fmt::format("the section at v = {:.3g} crosses itself.", between(first.y(), second.y(), motion.domainV())),
            "Even out its scaling and rotation along u."};
  const bool isNear = way < around * reach;
  const bool bends = (isNear || alongU < same) && (bendsTightly(motion, first.y()) || bendsTightly(motion, second.y()));
  if (bends)
    return {"the motion bends or turns more tightly than its sections are wide.",
            "Make the sections smaller there, or the bend of the trajectory wider."};
  if (isNear)
    return {"sections that follow each other turn or widen so fast that they pass through each other.",
            "Turn, scale or pull less there, or over a wider part, at a coarser level."};
  return {"two parts of the motion pass through each other.",
          "Move the trajectory apart there, or make the sections smaller."};
}

}  // namespace blossom::sweep
