#include "kernel/stroke.h"

#include "geometry/numeric/cubic_slopes.h"

namespace blossom::subdivision {
namespace {

Vec4 poleAt(const Vec3& p) { return {p.x(), p.y(), p.z(), 1}; }

}  // namespace

Curve polyline(std::span<const Vec3> points) {
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
  const Eigen::Map<const NumberRows> rows(points.front().data(), static_cast<Eigen::Index>(points.size()), 3);
  const NumberRows slopes = cubicSlopes(lengths, rows);
  Curve curve;
  curve.degree = 3;
  curve.knots = {0, 0};
  double along = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) along += lengths[i - 1];
    const Vec3 slope = slopes.row(static_cast<Eigen::Index>(i)).transpose();
    curve.knots.insert(curve.knots.end(), {along, along});
    curve.poles.push_back(poleAt(i > 0 ? Vec3(points[i] - lengths[i - 1] / 3 * slope) : points[i]));
    curve.poles.push_back(poleAt(i < lengths.size() ? Vec3(points[i] + lengths[i] / 3 * slope) : points[i]));
  }
  curve.knots.insert(curve.knots.end(), {along, along});
  return curve;
}

}  // namespace blossom::subdivision
