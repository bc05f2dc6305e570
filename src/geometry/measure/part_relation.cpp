#include "geometry/measure/part_relation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.h"

namespace blossom {

namespace {

using Kind = PartForm::Kind;

constexpr double parallel = 1e-7;  // radians; files store directions with about eight digits

/// Two directions and the angle from one to the other, which an arc around `at` shows.
struct Angle {
  Vec3 from, to, at;
  [[nodiscard]] double radians() const { return std::atan2(from.cross(to).norm(), from.dot(to)); }
};

bool isPlane(const PartForm& form) { return form.kind == Kind::Plane; }
bool isEdgeLine(const PartForm& form) { return form.kind == Kind::Line && form.ends; }

Angle acute(Angle angle) {
  if (angle.from.dot(angle.to) < 0) angle.to = -angle.to;
  return angle;
}

/// Straight edges that leave a common point keep their sides.
std::optional<Angle> atCommonEnd(const PartForm& a, const PartForm& b) {
  if (!isEdgeLine(a) || !isEdgeLine(b)) return std::nullopt;
  const double near = 1e-6 * std::max((a.ends->second - a.ends->first).norm(), (b.ends->second - b.ends->first).norm());
  for (const bool startA : {true, false})
    for (const bool startB : {true, false}) {
      const Vec3 &here = startA ? a.ends->first : a.ends->second, &thereA = startA ? a.ends->second : a.ends->first;
      const Vec3 &hereB = startB ? b.ends->first : b.ends->second, &thereB = startB ? b.ends->second : b.ends->first;
      if ((here - hereB).norm() <= near) return Angle{(thereA - here).normalized(), (thereB - hereB).normalized(), here};
    }
  return std::nullopt;
}

Angle lineToPlane(const Vec3& line, const Vec3& normal, const Vec3& at) {
  const Vec3 shadow = line - line.dot(normal) * normal;
  return {line, shadow.norm() < 1e-12 ? normal.unitOrthogonal() : shadow.normalized(), at};
}

std::optional<Angle> angleBetween(const PartForm& a, const PartForm& b, const Vec3& at) {
  if (auto corner = atCommonEnd(a, b)) return corner;
  if (a.hasAxis() && b.hasAxis()) return acute({a.direction, b.direction, at});
  if (a.hasAxis() && isPlane(b)) return lineToPlane(a.direction, b.direction, at);
  if (isPlane(a) && b.hasAxis()) return lineToPlane(b.direction, a.direction, at);
  if (!isPlane(a) || !isPlane(b)) return std::nullopt;
  const Vec3 crease = a.direction.cross(b.direction);
  if (crease.norm() < parallel) return acute({a.direction, b.direction, at});
  return acute({a.direction.cross(crease).normalized(), b.direction.cross(crease).normalized(), at});
}

std::optional<double> planeDistance(const PartForm& a, const PartForm& b) {
  if (!isPlane(a)) return isPlane(b) ? planeDistance(b, a) : std::nullopt;
  const double distance = std::abs((b.origin - a.origin).dot(a.direction));
  if (b.kind == Kind::Point || b.kind == Kind::Sphere) return distance;
  if (isPlane(b) && a.direction.cross(b.direction).norm() < parallel) return distance;
  // Axes of circles too: only where the line runs along the plane is there one distance.
  if (b.hasAxis() && std::abs(a.direction.dot(b.direction)) < parallel) return distance;
  return std::nullopt;
}

std::optional<double> axisDistance(const PartForm& a, const PartForm& b) {
  if (!a.hasAxis()) return b.hasAxis() && a.kind == Kind::Point ? axisDistance(b, a) : std::nullopt;
  const Vec3 between = b.origin - a.origin;
  if (b.kind == Kind::Point) return between.cross(a.direction).norm();
  if (!b.hasAxis()) return std::nullopt;
  const Vec3 common = a.direction.cross(b.direction);
  if (common.norm() < parallel) return between.cross(a.direction).norm();
  return std::abs(between.dot(common.normalized()));
}

std::optional<double> centreDistance(const PartForm& a, const PartForm& b) {
  const auto centred = [](const PartForm& form) { return form.hasCentre() || form.kind == Kind::Point; };
  if (!centred(a) || !centred(b) || (a.kind == Kind::Point && b.kind == Kind::Point)) return std::nullopt;
  return (b.origin - a.origin).norm();
}

double extent(const PartForm& form) {
  if (form.ends && form.kind == Kind::Line) return (form.ends->second - form.ends->first).norm();
  return form.radius > 0 ? form.radius : 0;
}

/// The two sides and the arc between them.
std::vector<std::vector<Vec3>> drawn(const Angle& angle, double radius) {
  constexpr int pieces = 32;
  const double sweep = angle.radians();
  const Vec3 across = (angle.to - angle.to.dot(angle.from) * angle.from).normalized();
  std::vector<Vec3> arc;
  arc.reserve(pieces + 1);
  for (int i = 0; i <= pieces; ++i) {
    const double t = sweep * i / pieces;
    arc.push_back(angle.at + radius * (std::cos(t) * angle.from + std::sin(t) * across));
  }
  return {arc, {arc.front(), angle.at, arc.back()}};
}

}  // namespace

void addRelation(Measurement& m, const PartGeometry& first, const PartGeometry& second, const FootPoints& feet) {
  const PartForm &a = first.form, &b = second.form;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) m.values.push_back({name, *value, MeasureUnit::Length});
  };
  const std::optional<Angle> angle = angleBetween(a, b, feet.first);
  if (angle) m.values.push_back({"angle", toDegrees(angle->radians()), MeasureUnit::Angle});
  add("plane_distance", planeDistance(a, b));
  add("axis_distance", axisDistance(a, b));
  add("center_distance", centreDistance(a, b));
  if (!angle || feet.distance() > 0 || angle->radians() < parallel) return;
  const auto it = std::find_if(m.values.begin(), m.values.end(), [](const Measure& x) { return x.name == "angle"; });
  std::rotate(m.values.begin(), it, it + 1);
  m.kind = "angle";
  double size = std::max(extent(a), extent(b));
  for (const PartForm* form : {&a, &b})
    if (extent(*form) > 0) size = std::min(size, extent(*form));
  const double radius = size > 0 ? 0.4 * size : 10;
  m.lines = drawn(*angle, radius);
  m.label = m.lines.front()[m.lines.front().size() / 2];
}

}  // namespace blossom
