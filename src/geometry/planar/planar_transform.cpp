#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

using Affine = Eigen::Matrix<double, 2, 3>;

Vec2 mapped(const Affine& affine, const Vec2& p) { return affine.leftCols<2>() * p + affine.col(2); }

bool isSimilarity(const Eigen::Matrix2d& linear) {
  const Vec2 a = linear.col(0);
  const Vec2 b = linear.col(1);
  const double scale = std::max(a.squaredNorm(), b.squaredNorm());
  constexpr double rounding = 1e-13;
  return std::abs(a.dot(b)) <= rounding * scale && std::abs(a.squaredNorm() - b.squaredNorm()) <= rounding * scale;
}

Segment transformedSegment(const Line2& line, const Affine& affine) {
  return Line2{mapped(affine, line.from), mapped(affine, line.to)};
}

Segment transformedSegment(const Spline2& spline, const Affine& affine) {
  Spline2 image = spline;
  for (Vec3& pole : image.poles) {
    const Vec2 xy = affine * pole;  // the translation is taken w times
    pole.head<2>() = xy;
  }
  return image;
}

Segment transformedSegment(const Arc2& arc, const Affine& affine) {
  const Eigen::Matrix2d linear = affine.leftCols<2>();
  if (!isSimilarity(linear))
    return transformedSegment(ellipticArc(arc.center, Vec2(arc.radius, 0), 1, arc.start, arc.sweep), affine);
  const Vec2 direction = linear * Vec2(std::cos(arc.start), std::sin(arc.start));
  const double scale = std::sqrt(std::abs(linear.determinant()));
  return Arc2{mapped(affine, arc.center), arc.radius * scale, std::atan2(direction.y(), direction.x()),
              linear.determinant() < 0 ? -arc.sweep : arc.sweep};
}

void checkInvertible(const Affine& affine) {
  const Eigen::Matrix2d linear = affine.leftCols<2>();
  if (!affine.allFinite() || std::abs(linear.determinant()) <= 1e-14 * linear.squaredNorm())
    throw Error(ErrorCode::Degenerate, "The transformation flattens the plane into a line or a point.",
                "Give scales other than zero.");
}

}  // namespace

Spline2 ellipticArc(const Vec2& center, const Vec2& axis, double ratio, double start, double sweep) {
  const Vec2 other = ratio * Vec2(-axis.y(), axis.x());
  const auto at = [&](double angle, double weight) {
    // Between two points of the arc, the tangents meet at (cos a, sin a) / cos(step / 2); times that weight it is the
    // circle's own point.
    const Vec2 offset = std::cos(angle) * axis + std::sin(angle) * other;
    const Vec2 weighted = weight * center + offset;
    return Vec3(weighted.x(), weighted.y(), weight);
  };
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 2) - 1e-9)));
  const double step = sweep / pieces;
  Spline2 spline{2, {0, 0, 0}, {at(start, 1)}};
  for (int i = 0; i < pieces; ++i) {
    spline.poles.push_back(at(start + (i + 0.5) * step, std::cos(step / 2)));
    spline.poles.push_back(at(start + (i + 1) * step, 1));
    spline.knots.insert(spline.knots.end(), 2, std::abs((i + 1) * step));
  }
  spline.knots.push_back(spline.knots.back());
  return spline;
}

Segment transformed(const Segment& segment, const Affine& affine) {
  checkInvertible(affine);
  return std::visit([&](const auto& s) { return transformedSegment(s, affine); }, segment);
}

Path transformed(Path path, const Affine& affine) {
  for (Segment& segment : path.segments) segment = transformed(segment, affine);
  return path;
}

}  // namespace blossom
