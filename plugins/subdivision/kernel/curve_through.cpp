#include "kernel/curve_through.h"

namespace blossom::subdivision {
namespace {

Vec4 poleAt(const Vec3& p) { return {p.x(), p.y(), p.z(), 1}; }

/// Slopes of the natural spline: a tridiagonal system, solved by elimination.
std::vector<Vec3> slopes(std::span<const Vec3> points, const std::vector<double>& lengths) {
  const std::size_t n = points.size();
  std::vector<double> diagonal(n), above(n), below(n);
  std::vector<Vec3> right(n);
  const auto chord = [&](std::size_t i) -> Vec3 { return (points[i + 1] - points[i]) / lengths[i]; };
  diagonal[0] = diagonal[n - 1] = 2;
  above[0] = below[n - 1] = 1;
  right[0] = 3 * chord(0);
  right[n - 1] = 3 * chord(n - 2);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    below[i] = lengths[i];
    diagonal[i] = 2 * (lengths[i - 1] + lengths[i]);
    above[i] = lengths[i - 1];
    right[i] = 3 * (lengths[i] * chord(i - 1) + lengths[i - 1] * chord(i));
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double share = below[i] / diagonal[i - 1];
    diagonal[i] -= share * above[i - 1];
    right[i] -= share * right[i - 1];
  }
  std::vector<Vec3> slope(n);
  slope[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) slope[i] = (right[i] - above[i] * slope[i + 1]) / diagonal[i];
  return slope;
}

}  // namespace

Curve polylineThrough(std::span<const Vec3> points) {
  Curve curve;
  curve.degree = 1;
  double along = 0;
  curve.knots = {0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) along += (points[i] - points[i - 1]).norm();
    curve.poles.push_back(poleAt(points[i]));
    curve.knots.push_back(along);
  }
  curve.knots.push_back(along);
  return curve;
}

Curve splineThrough(std::span<const Vec3> points) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) lengths.push_back((points[i + 1] - points[i]).norm());
  const std::vector<Vec3> slope = slopes(points, lengths);
  Curve curve;
  curve.degree = 3;
  curve.knots = {0, 0};
  double along = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) along += lengths[i - 1];
    curve.knots.insert(curve.knots.end(), {along, along});
    curve.poles.push_back(poleAt(i > 0 ? Vec3(points[i] - lengths[i - 1] / 3 * slope[i]) : points[i]));
    curve.poles.push_back(poleAt(i < lengths.size() ? Vec3(points[i] + lengths[i] / 3 * slope[i]) : points[i]));
  }
  curve.knots.insert(curve.knots.end(), {along, along});
  return curve;
}

}  // namespace blossom::subdivision
