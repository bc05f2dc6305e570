#include "geometry/values/surface_curvature.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace blossom {

std::optional<SurfaceCurvature> curvatureOf(const SurfaceJet& jet) {
  const double speed = jet.u.norm(), other = jet.v.norm();
  const Vec3 cross = jet.u.cross(jet.v);
  const double area = cross.norm();
  // A tangent that vanishes beside the other one: what is left of it is rounding.
  if (!(area > 1e-10 * speed * other) || !(std::min(speed, other) > 1e-8 * std::max(speed, other))) return std::nullopt;
  const Vec3 n = cross / area;
  // v = along * e1 + across * e2 with e1 = u / |u|.
  const double along = jet.v.dot(jet.u) / speed, across = area / speed;
  const double a = jet.uu.dot(n) / (speed * speed);
  const double b = (jet.uv.dot(n) / speed - along * a) / across;
  const double d = (jet.vv.dot(n) - along * along * a - 2 * along * across * b) / (across * across);
  const SurfaceCurvature result{a * d - b * b, -(a + d) / 2, std::hypot((a - d) / 2, b)};
  if (!std::isfinite(result.gaussian) || !std::isfinite(result.mean) || !std::isfinite(result.spread)) return std::nullopt;
  return result;
}

}  // namespace blossom
