#include "geometry/planar/sums/thin_chain.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace blossom::planar {
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

/// By least squares of the squared radius (Kasa 1976), about the first point; nothing when a point is off, or the middle of
/// a chord, as those of a square with points on its sides are.
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
  const auto isOff = [&](const Vec2& p) { return std::abs((p - centre).norm() - radius) > within; };
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isOff(points[i]) || (i > 0 && isOff((points[i - 1] + points[i]) / 2))) return std::nullopt;
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

Segment segmentAlong(Points points, const ChainFit& fit) {
  if (fit.curved && !liesOnLine(points, fit.within))
    if (const auto circle = circleThrough(points, fit.within))
      return arcAlong(throughEnds(*circle, points.front(), points.back()), points);
  return Line2{points.front(), points.back()};
}

/// How many points from the first one on fit, found by steps that double and then halve; 0 when not even `least` do.
template <class Fits>
std::size_t longestStart(Points points, std::size_t least, Fits fits) {
  if (points.size() < least || !fits(points.first(least))) return 0;
  std::size_t good = least, bad = points.size() + 1;
  for (std::size_t step = 1; good + 1 < bad;) {
    const std::size_t next = bad <= points.size() ? good + (bad - good) / 2 : std::min(good + step, points.size());
    (fits(points.first(next)) ? good : bad) = next;
    step *= 2;
  }
  return good;
}

/// How many points one line or arc passes.
std::size_t pointsOfSegment(Points points, const ChainFit& fit) {
  constexpr std::size_t ofLine = 3, ofCircle = 5;
  const auto onLine = [&](Points some) { return liesOnLine(some, fit.within); };
  const auto onCircle = [&](Points some) { return circleThrough(some, fit.within).has_value(); };
  const std::size_t line = longestStart(points, ofLine, onLine);
  return std::max({std::size_t{2}, line, fit.curved ? longestStart(points, ofCircle, onCircle) : 0});
}

}  // namespace

Path fittedChain(const std::vector<Vec2>& points, bool isRing, const ChainFit& fit, const Progress& progress) {
  Path path;
  path.closed = isRing;
  const Points all(points);
  if (isRing && fit.curved)
    if (const auto circle = circleThrough(all, fit.within)) {
      Arc2 arc = arcAlong(*circle, all);
      arc.sweep = arc.sweep > 0 ? 2 * std::numbers::pi : -2 * std::numbers::pi;
      path.segments.emplace_back(arc);
      return path;
    }
  for (std::size_t first = 0; first + 1 < points.size();) {
    progress.check();
    const std::size_t count = pointsOfSegment(all.subspan(first), fit);
    path.segments.push_back(segmentAlong(all.subspan(first, count), fit));
    first += count - 1;
  }
  return path;
}

}  // namespace blossom::planar
