#include "manipulators/curve_cage.h"

#include "kernel/four_point.h"

namespace blossom::subdivision {
namespace {

std::vector<Vec3> polesOf(const Curve& curve) {
  std::vector<Vec3> points;
  for (const Vec4& pole : curve.poles) points.emplace_back(pole.head<3>());
  return points;
}

/// Ends of `spans` pieces of the same length; of a closed curve the last is the first.
std::vector<Foot> evenJoints(std::size_t spans, bool closed) {
  std::vector<Foot> joints;
  for (std::size_t k = 0; k < spans + (closed ? 0 : 1); ++k)
    joints.push_back({0, static_cast<double>(k) / static_cast<double>(spans), 0});
  return joints;
}

/// The knots within the domain, each once.
std::vector<Foot> knotJoints(const Curve& curve) {
  const auto [from, to] = curve.domain();
  std::vector<Foot> joints;
  for (const double knot : curve.knots) {
    if (knot < from || knot > to) continue;
    const double u = (knot - from) / (to - from);
    if (joints.empty() || joints.back().u < u) joints.push_back({0, u, 0});
  }
  return joints;
}

CurveCage ofPolygon(ControlPolygon polygon, CurveScheme scheme) {
  CurveCage cage;
  cage.closed = polygon.closed;
  const std::size_t n = polygon.points.size();
  if (scheme == CurveScheme::FourPoint)
    cage.curve = std::make_unique<FourPointCurve>(polygon);
  else
    cage.curve = std::make_unique<LimitCurve>(polygon, scheme);
  // The pieces of an open quadratic curve begin and end within an edge.
  const bool whole = polygon.closed || scheme == CurveScheme::Quadratic;
  cage.joints = evenJoints(whole ? n : n - 1, polygon.closed);
  cage.points = std::move(polygon.points);
  return cage;
}

}  // namespace

CurveCage curveCage(const Shape& input, SchemeChoice chosen) {
  const Shape shape = cageOf(input);
  checkScheme(shape, chosen);
  if (auto polygon = polygonOf(shape, chosen)) return ofPolygon(std::move(*polygon), curveScheme(chosen));
  const Curve& spline = splineOf(shape);
  CurveCage cage;
  cage.points = polesOf(spline);
  cage.curve = std::make_unique<LimitCurve>(spline);
  cage.joints = knotJoints(spline);
  return cage;
}

std::vector<Vec3> controlPoints(const Shape& input, SchemeChoice chosen) {
  const Shape shape = cageOf(input);
  if (auto polygon = polygonOf(shape, chosen)) return std::move(polygon->points);
  return polesOf(splineOf(shape));
}

}  // namespace blossom::subdivision
