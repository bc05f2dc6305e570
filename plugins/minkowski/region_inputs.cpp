#include "region_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/polygons.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

bool isPoint(const Path& path) { return !path.segments.empty() && length(path) == 0; }

/// Lines without length, each place once. They are taken out of the drawing, whose ends they would join.
std::vector<Vec2> pointsTakenFrom(Curves& drawing) {
  std::vector<Vec2> points;
  for (const Path& path : drawing.paths)
    if (isPoint(path)) points.push_back(startPoint(path));
  std::erase_if(drawing.paths, isPoint);
  std::sort(points.begin(), points.end(), fartherLeft);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// What lies at the end of a line or curve is dirt, not a point.
void dropPointsAtEnds(const std::vector<Path>& paths, std::vector<Vec2>& points) {
  for (const Path& path : paths)
    for (const Segment& segment : path.segments)
      for (const Vec2& end : {startPoint(segment), endPoint(segment)}) {
        const auto [first, last] = std::equal_range(points.begin(), points.end(), end, fartherLeft);
        points.erase(first, last);
      }
}

/// A line without length stands for a point; anything else so short is dirt, as in toRegion.
PlanarSet setOfDrawing(Curves drawing) {
  PlanarSet set;
  set.points = pointsTakenFrom(drawing);
  dropPointsAtEnds(drawing.paths, set.points);
  Curves closed{{}, drawing.fillRule};
  for (Path& path : joined(drawing).paths) {
    if (path.segments.empty()) continue;
    if (path.closed)
      closed.paths.push_back(std::move(path));
    else if (length(path) > Tolerance{}.joining)
      set.curves.push_back(std::move(path));
  }
  if (!closed.paths.empty() || set.empty()) set.area = toRegion(closed);
  return set;
}

PlanarSet setOfCurve(const Curve& curve) {
  for (const Vec4& pole : curve.poles)
    if (std::abs(pole.z()) > Tolerance{}.confusion * pole.w())
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The curve is not in the plane z = 0: a pole lies {:.3g} mm above it.", pole.z() / pole.w()),
                  "Move or turn it into that plane.");
  Path path;
  if (curve.degree == 1)  // it runs from pole to pole
    for (std::size_t k = 1; k < curve.poles.size(); ++k) {
      const Vec4 &from = curve.poles[k - 1], &to = curve.poles[k];
      path.segments.emplace_back(Line2{from.head<2>() / from.w(), to.head<2>() / to.w()});
    }
  else
    path.segments.emplace_back(toSpline(curve));
  path.closed = (startPoint(path) - endPoint(path)).norm() <= Tolerance{}.joining;
  return setOfDrawing({{std::move(path)}, FillRule::EvenOdd});
}

PlanarSet setOf(const Shape& shape) {
  if (const auto* region = shape.get<Region>()) return {*region};
  if (const auto* drawing = shape.get<Curves>()) return setOfDrawing(*drawing);
  if (const auto* curve = shape.get<Curve>()) return setOfCurve(*curve);
  throwWrongKind(shape);
}

}  // namespace

std::vector<PlanarSet> setsOf(const Inputs& inputs) {
  std::vector<PlanarSet> sets;
  for (const Shape& shape : inputs.of(0)) sets.push_back(setOf(shape));
  return sets;
}

std::vector<Region> regionsOf(const Inputs& inputs) {
  std::vector<Region> regions;
  for (const Shape& shape : inputs.of(0)) {
    const Region* region = shape.get<Region>();
    if (!region) throwWrongKind(shape);
    regions.push_back(*region);
  }
  return regions;
}

std::optional<double> toleranceOf(const Value& given) {
  return given.is_null() ? std::nullopt : std::optional(given.get<double>());
}

ParameterSpec toleranceSpec() {
  return whenNone(optional(positiveLength()),
                  "a 10,000th of each shape's size and a 500th of its thickness, at most 0.01 mm");
}

Evaluated evaluatedSet(SetSumResult result) {
  PlanarSet& set = result.set;
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.stats["empty"] = set.empty();
  out.warnings = std::move(result.warnings);
  if (set.curves.empty() && set.points.empty()) {
    out.shape = std::move(set.area);
    return out;
  }
  out.stats["open_curves"] =
      std::count_if(set.curves.begin(), set.curves.end(), [](const Path& curve) { return !curve.closed; });
  out.stats["points"] = set.points.size();
  Curves drawing = toCurves(set.area);
  drawing.paths.insert(drawing.paths.end(), set.curves.begin(), set.curves.end());
  for (const Vec2& point : set.points) drawing.paths.push_back({{Line2{point, point}}, false, {}, {}});
  out.shape = std::move(drawing);
  return out;
}

Evaluated evaluatedSum(RegionSumResult result) {
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.warnings = std::move(result.warnings);
  out.shape = std::move(result.region);
  return out;
}

}  // namespace blossom::minkowski
