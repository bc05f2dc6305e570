#include <fmt/format.h>

#include "features_outline.h"
#include "features_outline_value.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"

namespace blossom::modeling {
namespace {

struct DrawnParameters {
  Vec3 start = Vec3::Zero();
  std::vector<Value> segments;
  bool closed = true;
};

ParameterSpec field(const char* name, ParameterSpec spec, const char* help, Value fallback = {}) {
  spec.name = name;
  spec.help = help;
  spec.fallback = std::move(fallback);
  return spec;
}

ParameterSpec segmentRecord() {
  return record(
      {field("kind", choice({"line", "arc", "spline"}), "What joins the point before to this one.", "line"),
       field("to", point(), "Where the segment ends."),
       field("through", list(point()), "A point that an arc passes; points that a spline passes on its way.",
             Value::array()),
       field("tangent", flag(), "Whether an arc or a spline goes on in the direction of the segment before.", false)});
}

DrawnOutline drawn(const DrawnParameters& p) {
  DrawnOutline outline{inPlane(p.start), {}, p.closed};
  outline.segments.reserve(p.segments.size());
  const auto check = [](const Value& value) { inPlane(Vec3(value.at(0), value.at(1), value.at(2))); };
  for (const Value& record : p.segments) {
    check(record.at("to"));
    for (const Value& point : record.at("through")) check(point);
    outline.segments.push_back(drawnSegmentOf(record));
  }
  return outline;
}

Evaluated evaluateDrawn(const DrawnParameters& p, const Inputs&, const Progress& progress) {
  const Path path = toPath(drawn(p));
  const auto place = selfCrossing(path, progress);
  if (!p.closed) {
    Evaluated open{Curves{{path}}, Value::object(), {}};
    if (place) open.warnings.push_back(fmt::format("The outline meets itself at ({:.6g}, {:.6g}).", place->x(), place->y()));
    return open;
  }
  if (place)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The outline meets itself at ({:.6g}, {:.6g}).", place->x(), place->y()),
                "Move its points so that it neither crosses, touches nor runs back over itself.");
  return {toRegion({{path}}), Value::object(), {}};
}

}  // namespace

FeatureType drawnFeature() {
  using P = DrawnParameters;
  return feature<P>("modeling.outline", "Outline", "A drawn outline of lines, arcs and splines; a region when it is closed.")
      .icon("outline")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .parameter("start", &P::start, point(), "Where the outline begins, in the plane z = 0.")
      .parameter("segments", &P::segments, list(segmentRecord()), "The segments, one after the other.")
      .parameter("closed", &P::closed, flag(),
                 "Whether it encloses an area. If its last segment does not return to the start, a line closes it.")
      .example(
          "blossom outline --segments '[{\"to\": [40, 0]}, {\"kind\": \"arc\", \"through\": [[50, 10]], \"to\": [40, 20]}, "
          "{\"to\": [0, 20]}]' -o outline.dxf")
      .evaluate(evaluateDrawn);
}

}  // namespace blossom::modeling
