#include "morph_control.h"

#include "control_shapes.h"
#include "core/error.h"

namespace blossom::minkowski {

namespace {

ParameterSpec angleNamed(std::string name, std::string help) {
  ParameterSpec spec = angle();
  spec.name = std::move(name);
  spec.help = std::move(help);
  spec.fallback = 0.0;
  return spec;
}

}  // namespace

void refuseBesidesKnots(bool blossomOrPath, bool degreeElevate) {
  if (!blossomOrPath && !degreeElevate) return;
  throw Error(ErrorCode::InvalidParameter, "A B-spline of shapes takes no blossom parameters, path or degree elevation.",
              "Leave them out, or the degree and the knots.");
}

Shape sequenceOf(std::vector<Region> regions, std::vector<double> places) {
  Sequence sequence;
  sequence.times = std::move(places);
  for (Region& region : regions) sequence.frames.push_back(shapeOfControl(std::move(region)));
  return Shape(std::move(sequence));
}

Evaluated morphedBySpline(const std::vector<Region>& shapes, const ShapeKnots& spline, const std::vector<double>& times,
                          const std::vector<double>& places, const MorphOptions& options, const Progress& progress) {
  MorphResult result = splineMorph(shapes, spline, times, options, progress);
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.stats["degree"] = spline.degree;
  if (const auto continuity = continuityOf(spline)) out.stats["continuity"] = *continuity;
  if (places.empty()) out.stats["influences"] = influences(spline, times.front());
  out.shape =
      places.empty() ? shapeOfControl(std::move(result.regions.front())) : sequenceOf(std::move(result.regions), places);
  return out;
}

ParameterSpec sectorsSpec() {
  return list(record({angleNamed("from", "First direction of the sector, counter-clockwise from +x."),
                      angleNamed("to", "Last direction.")}));
}

}  // namespace blossom::minkowski
