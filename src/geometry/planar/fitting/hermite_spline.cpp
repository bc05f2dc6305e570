#include "geometry/planar/fitting/hermite_spline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace blossom::planar {
namespace {

using Cubic = std::array<Vec2, 4>;

double turnBetween(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

Cubic cubicBetween(const DirectedPoint& from, const DirectedPoint& to) {
  const double chord = (to.at - from.at).norm(), cosine = std::cos(turnBetween(from.along, to.along) / 4);
  const double handle = chord / (3 * cosine * cosine);
  return {from.at, from.at + handle * from.along, to.at - handle * to.along, to.at};
}

Vec2 pointAt(const Cubic& c, double t) {
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

Vec2 derivativeAt(const Cubic& c, double t) {
  const double s = 1 - t;
  return 3 * (s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}

/// By Newton's method from a share of the chord.
double distanceFrom(const Cubic& cubic, const Vec2& p) {
  const Vec2 chord = cubic[3] - cubic[0];
  double t = std::clamp((p - cubic[0]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
  constexpr double enough = 1e-7;  // of the parameter: the distance is known far better
  for (int i = 0; i < 6; ++i) {
    const Vec2 derivative = derivativeAt(cubic, t);
    const double before = t, step = (p - pointAt(cubic, t)).dot(derivative) / std::max(derivative.squaredNorm(), 1e-300);
    t = std::clamp(t + step, 0.0, 1.0);
    if (std::abs(t - before) < enough) break;
  }
  return (p - pointAt(cubic, t)).norm();
}

/// Whether a cubic passes the piece between two points, which has no point of its own where it is long.
bool passesBetween(const Cubic& cubic, const DirectedPoint& from, const DirectedPoint& to, double tolerance) {
  constexpr double isLong = 1.0 / 16;  // of the cubic
  if ((to.at - from.at).norm() < isLong * (cubic[3] - cubic[0]).norm()) return true;
  const Cubic piece = cubicBetween(from, to);
  constexpr std::array places{0.25, 0.5, 0.75};
  return std::all_of(places.begin(), places.end(),
                     [&](double t) { return distanceFrom(cubic, pointAt(piece, t)) <= tolerance; });
}

/// Whether one cubic may stand for all points and for the pieces between them.
bool passes(std::span<const DirectedPoint> points, double tolerance) {
  constexpr double widest = 1.2;  // radians
  double turn = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    turn += std::abs(turnBetween(points[i - 1].along, points[i].along));
    if (turn > widest) return false;
  }
  const Cubic cubic = cubicBetween(points.front(), points.back());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 < points.size() && distanceFrom(cubic, points[i].at) > tolerance) return false;
    if (!passesBetween(cubic, points[i - 1], points[i], tolerance)) return false;
  }
  return true;
}

/// The farthest point that is reached with one cubic, by doubling and halving the step.
std::size_t farthestFrom(const std::vector<DirectedPoint>& points, std::size_t from, double tolerance) {
  const std::size_t last = points.size() - 1;
  const auto reaches = [&](std::size_t to) { return passes(std::span(points).subspan(from, to - from + 1), tolerance); };
  std::size_t good = from + 1, step = 1;
  while (good + step <= last && reaches(good + step)) {
    good += step;
    step *= 2;
  }
  for (; step > 0; step /= 2)
    if (good + step <= last && reaches(good + step)) good += step;
  return good;
}

}  // namespace

bool keepsNear(const DirectedPoint& from, const DirectedPoint& to, std::span<const Vec2> places, double within) {
  const Cubic cubic = cubicBetween(from, to);
  return std::all_of(places.begin(), places.end(), [&](const Vec2& p) { return distanceFrom(cubic, p) <= within; });
}

Spline2 splineThrough(const std::vector<DirectedPoint>& points, double tolerance) {
  Spline2 spline{3, {0, 0, 0, 0}, {points.front().at.homogeneous()}};
  double length = 0;
  for (std::size_t from = 0; from + 1 < points.size();) {
    const std::size_t to = farthestFrom(points, from, tolerance);
    const Cubic cubic = cubicBetween(points[from], points[to]);
    for (std::size_t k = 1; k < 4; ++k) spline.poles.push_back(cubic[k].homogeneous());
    length += (points[to].at - points[from].at).norm();
    spline.knots.insert(spline.knots.end(), 3, length);
    from = to;
  }
  spline.knots.push_back(length);
  return spline;
}

}  // namespace blossom::planar
