#include "kernel/sets/thin_chain.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace blossom::minkowski {
namespace {

using Points = std::span<const Vec2>;

bool liesOnLine(Points points, double within) {
  const Vec2 along = points.back() - points.front();
  const double length = along.norm();
  if (!(length > within)) return false;
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec2& p) { return std::abs(cross(along, Vec2(p - points.front()))) <= within * length; });
}

struct FittedCircle {
  Vec2 centre;
  double radius;
};

/// By least squares of the squared radius (Kasa 1976), about the first point; nothing when a point is off.
std::optional<FittedCircle> circleThrough(Points points, double within) {
  if (points.size() < 5) return std::nullopt;
  Eigen::MatrixX3d equations(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd squares(static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < squares.size(); ++i) {
    const Vec2 p = points[static_cast<std::size_t>(i)] - points.front();
    equations.row(i) << 2 * p.x(), 2 * p.y(), 1;
    squares[i] = p.squaredNorm();
  }
  const Eigen::Vector3d solution = equations.colPivHouseholderQr().solve(squares);
  const Vec2 centre = points.front() + solution.head<2>();
  const double radius = std::sqrt(solution.z() + solution.head<2>().squaredNorm());
  if (!std::isfinite(radius) || !(radius > within)) return std::nullopt;
  for (const Vec2& p : points)
    if (std::abs((p - centre).norm() - radius) > within) return std::nullopt;
  return FittedCircle{centre, radius};
}

double sweepAround(const Vec2& centre, Points points) {
  double sweep = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 from = points[i - 1] - centre, to = points[i] - centre;
    sweep += std::atan2(cross(from, to), from.dot(to));
  }
  return sweep;
}

Arc2 arcAlong(const FittedCircle& circle, Points points) {
  const Vec2 from = points.front() - circle.centre;
  return {circle.centre, circle.radius, std::atan2(from.y(), from.x()), sweepAround(circle.centre, points)};
}

/// The centre moved so that the arc passes the first and the last point.
FittedCircle throughEnds(const FittedCircle& circle, const Vec2& from, const Vec2& to) {
  const Vec2 middle = (from + to) / 2, along = to - from;
  const double half = along.norm() / 2;
  if (!(half > 0)) return circle;
  const Vec2 aside = Vec2(-along.y(), along.x()) / (2 * half);
  const Vec2 centre = middle + (circle.centre - middle).dot(aside) * aside;
  return {centre, (from - centre).norm()};
}

Segment segmentAlong(Points points, double within) {
  if (!liesOnLine(points, within))
    if (const auto circle = circleThrough(points, within))
      return arcAlong(throughEnds(*circle, points.front(), points.back()), points);
  return Line2{points.front(), points.back()};
}

bool isOneSegment(Points points, double within) {
  return points.size() == 2 || liesOnLine(points, within) || circleThrough(points, within);
}

}  // namespace

Path fittedChain(const std::vector<Vec2>& points, bool isRing, double within) {
  Path path;
  path.closed = isRing;
  const Points all(points);
  if (isRing)
    if (const auto circle = circleThrough(all, within)) {
      Arc2 arc = arcAlong(*circle, all);
      arc.sweep = arc.sweep > 0 ? 2 * std::numbers::pi : -2 * std::numbers::pi;
      path.segments.emplace_back(arc);
      return path;
    }
  for (std::size_t first = 0; first + 1 < points.size();) {
    std::size_t last = first + 1;
    for (std::size_t next = last + 1; next < points.size(); ++next)
      if (isOneSegment(all.subspan(first, next - first + 1), within)) last = next;
    path.segments.push_back(segmentAlong(all.subspan(first, last - first + 1), within));
    first = last;
  }
  return path;
}

}  // namespace blossom::minkowski
