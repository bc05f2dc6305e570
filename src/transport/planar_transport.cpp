#include "transport/planar_transport.h"

#include "transport/numbers.h"

namespace blossom {

namespace {

Value segmentValue(const Line2& line) { return {{"line", {vectorValue(line.from), vectorValue(line.to)}}}; }
Value segmentValue(const Arc2& arc) { return {{"arc", {vectorValue(arc.center), arc.radius, arc.start, arc.sweep}}}; }
Value segmentValue(const Spline2& s) { return {{"spline", {s.degree, s.knots, vectorsValue(s.poles)}}}; }

Segment toSegment(const Value& value) {
  const auto entry = value.begin();
  const std::string& kind = entry.key();
  const Value& v = entry.value();
  if (kind == "line") return Line2{toVector<Vec2>(v.at(0)), toVector<Vec2>(v.at(1))};
  if (kind == "arc") return Arc2{toVector<Vec2>(v.at(0)), v.at(1), v.at(2), v.at(3)};
  return Spline2{v.at(0), v.at(1).get<std::vector<double>>(), toVectors<Vec3>(v.at(2))};
}

}  // namespace

Value pathsValue(const std::vector<Path>& paths) {
  Value all = Value::array();
  for (const Path& path : paths) {
    Value segments = Value::array();
    for (const Segment& segment : path.segments)
      segments.push_back(std::visit([](const auto& s) { return segmentValue(s); }, segment));
    all.push_back({{"closed", path.closed},
                   {"layer", path.layer},
                   {"color", colorValue(path.color)},
                   {"segments", std::move(segments)}});
  }
  return all;
}

std::vector<Path> toPaths(const Value& all) {
  std::vector<Path> paths;
  paths.reserve(all.size());
  for (const Value& each : all) {
    Path path;
    path.closed = each.at("closed");
    path.layer = each.at("layer");
    path.color = toColor(each.at("color"));
    for (const Value& segment : each.at("segments")) path.segments.push_back(toSegment(segment));
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace blossom
