#include "kernel/begin/profile_plane.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/numeric/gauss.h"

namespace blossom::sweep {

namespace {

/// Points along the curve, the same number on each span.
std::vector<Vec3> pointsAlong(const Curve& curve) {
  std::vector<Vec3> points;
  const BezierCurve bezier = toBezier(curve);
  for (std::size_t k = 0; k + 1 < bezier.breaks.size(); ++k)
    for (int i = 0; i < 16; ++i)
      points.push_back(point(curve, bezier.breaks[k] + (bezier.breaks[k + 1] - bezier.breaks[k]) * i / 16.0));
  return points;
}

}  // namespace

void refuseProfile(const std::string& why, const std::string& hint) {
  throw Error(ErrorCode::InvalidInput, "The profile cannot be used: " + why, hint);
}

ProfilePlane profilePlane(const Curve& curve) {
  const std::vector<Vec3> points = pointsAlong(curve);
  Vec3 area = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    area += (points[i] - points[0]).cross(points[(i + 1) % points.size()] - points[0]) / 2;
    size = std::max(size, (points[i] - points[0]).norm());
  }
  if (!(area.norm() > 1e-12 * size * size)) refuseProfile("it encloses no area.", "Give a closed outline.");
  Vec3 normal = area.normalized();
  if (normal.z() < -0.5 || (std::abs(normal.z()) <= 0.5 && normal.sum() < 0)) normal = -normal;
  for (const Vec4& pole : curve.poles) {
    const double off = std::abs(normal.dot(Vec3(pole.head<3>() / pole.w()) - points[0]));
    if (off > 1e-7 * size)
      refuseProfile(fmt::format("it leaves its plane by {:.3g} mm.", off), "Give an outline that lies in a plane.");
  }
  const Vec3 along = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 x = (along - normal.dot(along) * normal).normalized();
  return {points[0], x, normal.cross(x)};
}

Curve flattened(const Curve& curve, const ProfilePlane& plane, const Vec3& about) {
  Curve flat = curve;
  for (Vec4& pole : flat.poles) {
    const Vec3 arm = pole.head<3>() - pole.w() * about;
    pole = Vec4(plane.x.dot(arm), plane.y.dot(arm), 0, pole.w());
  }
  return flat;
}

Vec3 areaAndMoments(const Curve& flat) {
  const BezierCurve bezier = toBezier(flat);
  Vec3 sum = Vec3::Zero();
  const GaussRule rule = gaussRule(24);
  for (std::size_t k = 0; k + 1 < bezier.breaks.size(); ++k)
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double step = bezier.breaks[k + 1] - bezier.breaks[k];
      const auto d = derivatives(flat, bezier.breaks[k] + step * rule.nodes[i], 1);
      const double x = d[0].x() / d[0].w(), y = d[0].y() / d[0].w();
      const double dx = (d[1].x() - d[1].w() * x) / d[0].w(), dy = (d[1].y() - d[1].w() * y) / d[0].w();
      sum += step * rule.weights[i] * (x * dy - y * dx) * Vec3(1, x, y);
    }
  return sum;
}

}  // namespace blossom::sweep
