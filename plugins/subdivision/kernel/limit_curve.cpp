#include "kernel/limit_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::subdivision {
namespace {

void check(const ControlPolygon& polygon) {
  const std::size_t minimum = polygon.closed ? 3 : 2;
  if (polygon.points.size() < minimum)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The polygon has {} points; it needs {} or more.", polygon.points.size(), minimum),
                "Draw a longer polygon.");
  for (std::size_t i = 0; i < polygon.points.size(); ++i)
    if (!polygon.points[i].allFinite())
      throw Error(ErrorCode::InvalidInput, fmt::format("Point {} of the polygon has a coordinate that is no number.", i + 1),
                  "Correct the coordinate where the polygon was made.");
}

/// (side, middle, side) of each point with its neighbours; ends of an open polygon as they are.
std::vector<Vec3> averaged(const ControlPolygon& polygon, double side, double middle) {
  const std::size_t n = polygon.points.size();
  std::vector<Vec3> result = polygon.points;
  for (std::size_t i = 0; i < n; ++i)
    if (polygon.closed || (i > 0 && i + 1 < n))
      result[i] = side * polygon.points[(i + n - 1) % n] + middle * polygon.points[i] + side * polygon.points[(i + 1) % n];
  return result;
}

std::size_t edgeCount(const ControlPolygon& polygon) { return polygon.points.size() - (polygon.closed ? 0 : 1); }

ControlPolygon cubicStep(const ControlPolygon& polygon) {
  const std::size_t n = polygon.points.size();
  const std::vector<Vec3> moved = averaged(polygon, 1.0 / 8, 6.0 / 8);
  ControlPolygon result{{}, polygon.closed};
  for (std::size_t i = 0; i < n; ++i) {
    result.points.push_back(moved[i]);
    if (i < edgeCount(polygon)) result.points.emplace_back((polygon.points[i] + polygon.points[(i + 1) % n]) / 2);
  }
  return result;
}

ControlPolygon chaikinStep(const ControlPolygon& polygon) {
  const std::size_t n = polygon.points.size();
  ControlPolygon result{{}, polygon.closed};
  if (!polygon.closed) result.points.push_back(polygon.points.front());
  for (std::size_t i = 0; i < edgeCount(polygon); ++i) {
    const Vec3 &a = polygon.points[i], &b = polygon.points[(i + 1) % n];
    result.points.emplace_back((3 * a + b) / 4);
    result.points.emplace_back((a + 3 * b) / 4);
  }
  if (!polygon.closed) result.points.push_back(polygon.points.back());
  return result;
}

ControlPolygon fourPointStep(const ControlPolygon& polygon) {
  const auto n = static_cast<long>(polygon.points.size());
  const auto at = [&](long i) -> Vec3 {
    if (polygon.closed) return polygon.points[static_cast<std::size_t>((i + n) % n)];
    if (i < 0) return 2 * polygon.points.front() - polygon.points[1];
    if (i >= n) return 2 * polygon.points.back() - polygon.points[static_cast<std::size_t>(n - 2)];
    return polygon.points[static_cast<std::size_t>(i)];
  };
  ControlPolygon result{{}, polygon.closed};
  for (long i = 0; i < n; ++i) {
    result.points.push_back(at(i));
    if (i < static_cast<long>(edgeCount(polygon)))
      result.points.emplace_back((9 * (at(i) + at(i + 1)) - at(i - 1) - at(i + 2)) / 16);
  }
  return result;
}

/// The poles of the limit curve as combinations of the points of the polygon.
std::vector<Row> polesOf(std::size_t count, bool closed, CurveScheme scheme) {
  const int n = static_cast<int>(count), degree = scheme == CurveScheme::Quadratic ? 2 : 3;
  std::vector<Row> poles;
  if (closed) {
    for (int i = 0; i < n + degree; ++i) poles.push_back({{i % n}, {1.0}});
    return poles;
  }
  const bool mirrored = degree == 3;
  poles.push_back(mirrored ? Row{{0, 1}, {2.0, -1.0}} : Row{{0}, {1.0}});
  for (int i = 0; i < n; ++i) poles.push_back({{i}, {1.0}});
  poles.push_back(mirrored ? Row{{n - 1, n - 2}, {2.0, -1.0}} : Row{{n - 1}, {1.0}});
  return poles;
}

std::vector<double> uniformKnots(std::size_t poles, int degree) {
  std::vector<double> knots(poles + static_cast<std::size_t>(degree) + 1);
  for (std::size_t k = 0; k < knots.size(); ++k) knots[k] = static_cast<double>(k);
  return knots;
}

}  // namespace

ControlPolygon refined(const ControlPolygon& polygon, CurveScheme scheme) {
  check(polygon);
  switch (scheme) {
    case CurveScheme::Cubic:
      return cubicStep(polygon);
    case CurveScheme::Quadratic:
      return chaikinStep(polygon);
    case CurveScheme::FourPoint:
      break;
  }
  return fourPointStep(polygon);
}

ControlPolygon onLimit(const ControlPolygon& polygon, CurveScheme scheme) {
  check(polygon);
  if (scheme == CurveScheme::FourPoint) return polygon;
  if (scheme == CurveScheme::Cubic) return {averaged(polygon, 1.0 / 6, 4.0 / 6), polygon.closed};
  const std::size_t n = polygon.points.size();
  ControlPolygon result{{}, polygon.closed};
  if (!polygon.closed) result.points.push_back(polygon.points.front());
  for (std::size_t i = 0; i < edgeCount(polygon); ++i)
    result.points.emplace_back((polygon.points[i] + polygon.points[(i + 1) % n]) / 2);
  if (!polygon.closed) result.points.push_back(polygon.points.back());
  return result;
}

Curve splineOfPolygon(const ControlPolygon& polygon, CurveScheme scheme) {
  check(polygon);
  Curve curve;
  curve.degree = scheme == CurveScheme::Quadratic ? 2 : 3;
  for (const Row& row : polesOf(polygon.points.size(), polygon.closed, scheme)) {
    const Vec3 p = combined(row, polygon.points);
    curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  }
  curve.knots = uniformKnots(curve.poles.size(), curve.degree);
  return clamped(curve);
}

LimitCurve::LimitCurve(const ControlPolygon& polygon, CurveScheme scheme)
    : degree_(scheme == CurveScheme::Quadratic ? 2 : 3), count_(polygon.points.size()), closed_(polygon.closed) {
  check(polygon);
  poles_ = polesOf(count_, closed_, scheme);
  knots_ = uniformKnots(poles_.size(), degree_);
}

LimitCurve::LimitCurve(Curve curve) : degree_(curve.degree), knots_(std::move(curve.knots)), count_(curve.poles.size()) {
  for (int i = 0; i < static_cast<int>(count_); ++i) poles_.push_back({{i}, {1.0}});
}

Row LimitCurve::derivative(double u, int order) const {
  const auto p = static_cast<std::size_t>(degree_);
  const double from = knots_[p], length = knots_[poles_.size()] - from;
  const double t = from + u * length;
  const std::size_t span = findSpan(degree_, knots_, t);
  std::vector<double> basis(static_cast<std::size_t>(order + 1) * (p + 1));
  basisDerivatives(degree_, knots_, span, t, order, basis);
  std::map<int, double> weights;
  double scale = 1;
  for (int k = 0; k < order; ++k) scale *= length;
  for (std::size_t k = 0; k <= p; ++k) {
    const Row& pole = poles_[span - p + k];
    const double value = scale * basis[static_cast<std::size_t>(order) * (p + 1) + k];
    if (value == 0) continue;
    for (std::size_t i = 0; i < pole.indices.size(); ++i) weights[pole.indices[i]] += value * pole.weights[i];
  }
  Row row;
  for (const auto& [index, weight] : weights) {
    if (weight == 0) continue;  // where a mirrored point cancels another contribution
    row.indices.push_back(index);
    row.weights.push_back(weight);
  }
  return row;
}

Row LimitCurve::row(const Foot& foot) const { return derivative(foot.u, 0); }

Frame LimitCurve::frame(const Foot& foot, std::span<const Vec3> points) const {
  Frame frame;
  frame.at = combined(derivative(foot.u, 0), points);
  frame.du = combined(derivative(foot.u, 1), points);
  frame.duu = combined(derivative(foot.u, 2), points);
  return frame;
}

std::vector<Foot> LimitCurve::seeds() const {
  constexpr int perSpan = 8;
  const auto p = static_cast<std::size_t>(degree_);
  const double from = knots_[p], length = knots_[poles_.size()] - from;
  std::vector<Foot> feet;
  for (std::size_t s = p; s < poles_.size(); ++s) {
    if (!(knots_[s + 1] > knots_[s])) continue;
    for (int k = 0; k < perSpan; ++k) {
      const double t = knots_[s] + (k + 0.5) / perSpan * (knots_[s + 1] - knots_[s]);
      feet.push_back({0, (t - from) / length, 0});
    }
  }
  return feet;
}

std::vector<std::pair<int, int>> LimitCurve::edges() const {
  std::vector<std::pair<int, int>> list;
  const int n = static_cast<int>(count_);
  for (int i = 0; i + 1 < n; ++i) list.emplace_back(i, i + 1);
  if (closed_) list.emplace_back(n - 1, 0);
  return list;
}

}  // namespace blossom::subdivision
