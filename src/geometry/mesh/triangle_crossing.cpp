#include "geometry/mesh/triangle_crossing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "geometry/mesh/triangles_apart.h"

namespace blossom {
namespace {

using CrossingKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

CrossingKernel::Point_3 toCrossingKernel(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

CrossingKernel::Triangle_3 toCrossingKernel(const Triangle3& t) {
  return {toCrossingKernel(t[0]), toCrossingKernel(t[1]), toCrossingKernel(t[2])};
}

/// Corners that lie at one place.
struct SharedCorners {
  std::size_t count = 0;
  std::array<std::size_t, 3> inFirst{}, inSecond{};
};

SharedCorners sharedCorners(const Triangle3& a, const Triangle3& b) {
  SharedCorners shared;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j]) {
        shared.inFirst[shared.count] = i;
        shared.inSecond[shared.count++] = j;
      }
  return shared;
}

/// The side of `t` across from a corner, as a triangle that has collapsed to it.
Triangle3 sideAcross(const Triangle3& t, std::size_t corner) {
  return {t[(corner + 1) % 3], t[(corner + 2) % 3], t[(corner + 2) % 3]};
}

Vec3 meetingPlace(const Triangle3& a, const Triangle3& b) {
  const FootPoints feet = closestOnTriangles(a, b);
  return (feet.first + feet.second) / 2;
}

/// What two triangles have in common is convex, so beyond a shared corner it reaches the far side of one of them.
std::optional<Vec3> beyondCorner(const Triangle3& a, const Triangle3& b, std::size_t cornerOfA, std::size_t cornerOfB) {
  if (areApartBeyondCorner(a, b, cornerOfA, cornerOfB)) return std::nullopt;
  const auto meets = [](const Triangle3& triangle, const Triangle3& side) {
    const CrossingKernel::Segment_3 segment(toCrossingKernel(side[0]), toCrossingKernel(side[1]));
    return CGAL::do_intersect(toCrossingKernel(triangle), segment);
  };
  const Triangle3 sideOfA = sideAcross(a, cornerOfA), sideOfB = sideAcross(b, cornerOfB);
  if (meets(b, sideOfA)) return meetingPlace(b, sideOfA);
  if (meets(a, sideOfB)) return meetingPlace(a, sideOfB);
  return std::nullopt;
}

/// Over one side they overlap when they lie in one plane on the same side of it.
std::optional<Vec3> foldedOver(const Triangle3& a, const Triangle3& b, std::size_t freeOfA, std::size_t freeOfB) {
  const Vec3 &from = a[(freeOfA + 1) % 3], &to = a[(freeOfA + 2) % 3];
  if (lieAcross(from, to, a[freeOfA], b[freeOfB])) return std::nullopt;
  const auto p = toCrossingKernel(from), q = toCrossingKernel(to);
  const auto x = toCrossingKernel(a[freeOfA]), y = toCrossingKernel(b[freeOfB]);
  if (!CGAL::coplanar(p, q, x, y) || CGAL::coplanar_orientation(p, q, x, y) != CGAL::POSITIVE) return std::nullopt;
  return Vec3((from + to) / 2);
}

}  // namespace

bool isCollapsed(const Triangle3& t) {
  // Bounds of what rounding does to differences, to products and their difference, and of what underflows.
  constexpr double rounding = 1e-14, underflow = 1e-290;
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  const double size = u.lpNorm<Eigen::Infinity>() * v.lpNorm<Eigen::Infinity>();
  if (u.cross(v).lpNorm<Eigen::Infinity>() > rounding * size + underflow) return false;
  return CGAL::collinear(toCrossingKernel(t[0]), toCrossingKernel(t[1]), toCrossingKernel(t[2]));
}

std::optional<Vec3> crossingElsewhere(const Triangle3& a, const Triangle3& b) {
  const SharedCorners shared = sharedCorners(a, b);
  switch (shared.count) {
    case 0:
      if (areApart(a, b) || !CGAL::do_intersect(toCrossingKernel(a), toCrossingKernel(b))) return std::nullopt;
      return meetingPlace(a, b);
    case 1:
      return beyondCorner(a, b, shared.inFirst[0], shared.inSecond[0]);
    case 2:
      return foldedOver(a, b, 3 - shared.inFirst[0] - shared.inFirst[1], 3 - shared.inSecond[0] - shared.inSecond[1]);
    default:
      return Vec3((a[0] + a[1] + a[2]) / 3);
  }
}

}  // namespace blossom
