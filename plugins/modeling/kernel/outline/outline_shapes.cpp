#include "kernel/outline/outline_shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"

namespace blossom::modeling {
namespace {

using std::numbers::pi;

void demandPositive(double value, const char* what) {
  if (!(value > 0))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The {} must be above 0; it is {:g} mm.", what, value),
                fmt::format("Give a positive {}.", what));
}

Vec2 onCircle(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

Vec2 turned(const Vec2& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

Region polygonThrough(const std::vector<Vec2>& corners) {
  Path path;
  path.closed = true;
  path.segments.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k)
    path.segments.emplace_back(Line2{corners[k], corners[(k + 1) % corners.size()]});
  return {{std::move(path)}};
}

/// The line to the start of `arc`, unless it has no length, and the arc.
void addLineAndArc(Path& path, const Vec2& from, const Arc2& arc) {
  const Vec2 start = startPoint(Segment(arc));
  if ((start - from).norm() > 1e-12 * (1 + start.norm())) path.segments.emplace_back(Line2{from, start});
  path.segments.emplace_back(arc);
}

/// Quarter arcs around the corners of a smaller rectangle with half sides `x` and `y`.
Region roundedRectangle(double x, double y, double corner, const Vec2& center, double rotation) {
  const Vec2 middles[] = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  const auto quarter = [&](int k) {
    return Arc2{center + turned(middles[k], rotation), corner, rotation + (k - 1) * pi / 2, pi / 2};
  };
  Path path;
  path.closed = true;
  for (int k = 0; k < 4; ++k) addLineAndArc(path, endPoint(Segment(quarter((k + 3) % 4))), quarter(k));
  return {{std::move(path)}};
}

}  // namespace

double circumradius(int sides, double inner) { return inner / std::cos(pi / sides); }

Region regularPolygon(int sides, double radius, const Vec2& center, double rotation) {
  if (sides < 3)
    throw Error(ErrorCode::InvalidParameter, fmt::format("A polygon has at least 3 sides; {} were asked for.", sides),
                "Give 3 or more sides.");
  demandPositive(radius, "radius");
  std::vector<Vec2> corners;
  corners.reserve(static_cast<std::size_t>(sides));
  for (int k = 0; k < sides; ++k) corners.push_back(center + onCircle(radius, rotation + 2 * pi * k / sides));
  return polygonThrough(corners);
}

Region star(int points, double outer, double inner, const Vec2& center, double rotation) {
  if (points < 2)
    throw Error(ErrorCode::InvalidParameter, fmt::format("A star has at least 2 points; {} were asked for.", points),
                "Give 2 or more points.");
  demandPositive(outer, "outer radius");
  demandPositive(inner, "inner radius");
  std::vector<Vec2> corners;
  corners.reserve(2 * static_cast<std::size_t>(points));
  for (int k = 0; k < 2 * points; ++k)
    corners.push_back(center + onCircle(k % 2 == 0 ? outer : inner, rotation + pi * k / points));
  return polygonThrough(corners);
}

Region circle(double radius, const Vec2& center) {
  demandPositive(radius, "radius");
  return {{Path{{Arc2{center, radius, 0, 2 * pi}}, true, {}, {}}}};
}

Region ellipse(double a, double b, const Vec2& center, double rotation) {
  demandPositive(a, "first half-axis");
  demandPositive(b, "second half-axis");
  if (a == b) return circle(a, center);
  return {{Path{{ellipticArc(center, onCircle(a, rotation), b / a, 0, 2 * pi)}, true, {}, {}}}};
}

Region rectangle(double width, double height, double corner, const Vec2& center, double rotation) {
  demandPositive(width, "width");
  demandPositive(height, "height");
  if (corner > std::min(width, height) / 2)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("A corner radius of {:g} mm does not fit a rectangle of {:g} x {:g} mm.", corner, width, height),
                fmt::format("At most {:g} mm fits.", std::min(width, height) / 2));
  const double x = width / 2 - corner, y = height / 2 - corner;
  if (corner > 0) return roundedRectangle(x, y, corner, center, rotation);
  std::vector<Vec2> corners;
  for (const Vec2& p : {Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}) corners.push_back(center + turned(p, rotation));
  return polygonThrough(corners);
}

Region slot(double length, double width, const Vec2& center, double rotation) {
  demandPositive(length, "length");
  demandPositive(width, "width");
  if (width > length)
    throw Error(ErrorCode::InvalidParameter, fmt::format("A slot of length {:g} mm cannot be {:g} mm wide.", length, width),
                "The length is measured from end to end and must not be less than the width.");
  if (width == length) return circle(width / 2, center);
  const Vec2 half = turned({(length - width) / 2, 0}, rotation);
  const Arc2 right{center + half, width / 2, rotation - pi / 2, pi}, left{center - half, width / 2, rotation + pi / 2, pi};
  Path path;
  path.closed = true;
  addLineAndArc(path, endPoint(Segment(left)), right);
  addLineAndArc(path, endPoint(Segment(right)), left);
  return {{std::move(path)}};
}

}  // namespace blossom::modeling
