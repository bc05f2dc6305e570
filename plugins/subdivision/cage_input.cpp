#include "cage_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::subdivision {
namespace {

Vec3 inSpace(const Vec2& p) { return {p.x(), p.y(), 0}; }

/// Takes the end that repeats the beginning away.
ControlPolygon closedUp(std::vector<Vec3> points, bool closed) {
  if (points.size() > 2 && (points.back() - points.front()).norm() <= 1e-9) {
    closed = true;
    points.pop_back();
  }
  return {std::move(points), closed};
}

ControlPolygon polygonOfPath(const Curves& curves) {
  if (curves.paths.size() != 1)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("A control polygon is one path; the drawing has {}.", curves.paths.size()),
                "Keep one path of straight lines in the drawing.");
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < curves.paths[0].segments.size(); ++i) {
    const auto* line = std::get_if<Line2>(&curves.paths[0].segments[i]);
    if (!line)
      throw Error(ErrorCode::InvalidInput, fmt::format("Segment {} of the control polygon is no straight line.", i + 1),
                  "Draw the control polygon with straight lines.");
    if (points.empty()) points.push_back(inSpace(line->from));
    points.push_back(inSpace(line->to));
  }
  return closedUp(std::move(points), curves.paths[0].closed);
}

/// Whether the points fit into a drawing: z is 0 up to rounding.
bool liesInDrawing(const std::vector<Vec3>& points) {
  double size = 0, height = 0;
  for (const Vec3& p : points) {
    size = std::max(size, (p - points.front()).norm());
    height = std::max(height, std::abs(p.z()));
  }
  return height <= 1e-9 * size;
}

Curve curveThrough(const std::vector<Vec3>& points) {
  Curve curve;
  curve.degree = 1;
  const auto spans = static_cast<double>(points.size() - 1);
  for (const Vec3& p : points) curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  curve.knots.push_back(0);
  for (std::size_t i = 0; i < points.size(); ++i) curve.knots.push_back(static_cast<double>(i) / spans);
  curve.knots.push_back(1);
  return curve;
}

/// Whether the scheme makes of poles the very curve that has them, as far as a user may expect.
bool keepsCurve(int degree, SchemeChoice chosen) {
  return chosen == SchemeChoice::CatmullClark || (chosen == SchemeChoice::Cubic && degree == 3) ||
         (chosen == SchemeChoice::Quadratic && degree == 2);
}

}  // namespace

Shape cageOf(const Shape& input) {
  if (input.kind() != ShapeKind::Region) return input;
  std::optional<Curves> drawing = drawingOf(input);
  return drawing ? Shape(std::move(*drawing)) : input;
}

std::optional<ControlPolygon> polygonOf(const Shape& shape, SchemeChoice chosen) {
  if (const auto* curves = shape.get<Curves>()) return polygonOfPath(*curves);
  const Curve& curve = splineOf(shape);
  if (curve.degree != 1 && keepsCurve(curve.degree, chosen)) return {};
  std::vector<Vec3> points;
  for (const Vec4& pole : curve.poles) points.emplace_back(pole.head<3>() / pole.w());
  return closedUp(std::move(points), false);
}

Shape shapeOf(const ControlPolygon& polygon, const Shape& like) {
  std::vector<Vec3> points = polygon.points;
  if (polygon.closed) points.push_back(points.front());
  if (const auto* curves = like.get<Curves>(); curves && liesInDrawing(points)) {
    Curves result = *curves;
    Path& path = result.paths.front();
    path.segments.clear();
    path.closed = polygon.closed;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      path.segments.push_back(Line2{points[i].head<2>(), points[i + 1].head<2>()});
    return result;
  }
  return curveThrough(points);
}

const Curve& splineOf(const Shape& shape) {
  const auto* curve = shape.get<Curve>();
  if (!curve)
    throw Error(ErrorCode::InvalidInput, "The cage is neither a mesh nor a curve.", "Give an OBJ file or a polygon.");
  validate(*curve);
  if (!std::all_of(curve->poles.begin(), curve->poles.end(), [&](const Vec4& pole) { return pole.w() == 1; }))
    throw Error(ErrorCode::InvalidInput, "The curve has weights; subdivision knows none.",
                "Give a B-spline curve without weights, or a polygon.");
  return *curve;
}

void checkScheme(const Shape& cage, SchemeChoice chosen) {
  const bool mesh = cage.kind() == ShapeKind::Mesh;
  if (mesh && chosen != SchemeChoice::CatmullClark && chosen != SchemeChoice::Loop)
    throw Error(ErrorCode::InvalidInput, "This scheme takes a polygon or a curve; the cage is a mesh.",
                "Choose the scheme catmull-clark or loop.");
  if (!mesh && chosen == SchemeChoice::Loop)
    throw Error(ErrorCode::InvalidInput, "Loop's scheme takes a mesh of triangles; the cage is a curve.",
                "Choose the scheme cubic, quadratic or four-point.");
}

ParameterSpec schemeChoice() { return choice({"catmull-clark", "loop", "cubic", "quadratic", "four-point"}); }

}  // namespace blossom::subdivision
