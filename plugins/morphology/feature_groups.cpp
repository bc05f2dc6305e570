#include "feature_groups.h"

#include <algorithm>

namespace blossom::morphology {

namespace {

const char* wayOf(const MorphologyStats& stats) {
  switch (stats.way) {
    case Way::Prisms:
      return "prisms";
    case Way::Hulls:
      return "hulls";
    case Way::Planes:
      return "planes";
    case Way::Field:
      return "field";
    case Way::Arranged:
      break;
  }
  return "arranged";
}

Value statsOf(const MorphologyStats& stats) {
  Value all{
      {"candidates", stats.candidates}, {"pairings", stats.pairings},  {"check_ms", stats.checkMs}, {"sum_ms", stats.sumMs},
      {"unite_ms", stats.uniteMs},      {"output_ms", stats.outputMs}, {"way", wayOf(stats)}};
  if (stats.way == Way::Arranged) {
    all["of_corners_and_faces"] = stats.families[0];
    all["of_faces_and_corners"] = stats.families[1];
    all["of_edges"] = stats.families[2];
    all["deep_inside"] = stats.leftOut;
  }
  return all;
}

}  // namespace

Evaluated evaluatedFrom(MorphologyResult result, const std::vector<double>& times) {
  Evaluated out;
  out.stats = statsOf(result.stats);
  out.warnings = std::move(result.warnings);
  for (Mesh& solid : result.solids) solid.flatFaces = result.stats.way != Way::Field;
  if (times.empty()) {
    out.shape = std::move(result.solids.front());
    return out;
  }
  Sequence sequence;
  for (Mesh& solid : result.solids) {
    sequence.times.push_back(times.at(sequence.frames.size()));
    sequence.frames.emplace_back(std::move(solid));
  }
  out.shape = std::move(sequence);
  return out;
}

std::vector<double> controlled(Control control, const Value& curve, std::vector<double> times) {
  std::vector<ControlPoint> points;
  points.reserve(curve.size());
  for (const Value& pair : curve) points.push_back({pair.at(0).get<double>(), pair.at(1).get<double>()});
  for (double& t : times) t = controlValue(control, points, t);
  return times;
}

ParameterSpec ballRadius() {
  ParameterSpec spec = positiveLength();
  spec.maximum = 1e9;  // mm from the origin, beyond which no solid is taken
  return spec;
}

ParameterSpec controlChoice() { return choice({"linear", "ease", "ease-in", "ease-out", "curve"}); }

ParameterSpec controlCurveSpec() {
  ParameterSpec spec = controlCurve();
  spec.minimum = 0;
  spec.maximum = 1;
  return onlyFor(spec, "control", {"curve"});
}

std::vector<double> frameTimes(int frames) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(std::max(0, frames)));
  for (int k = 0; k < frames; ++k) times.push_back(frames == 1 ? 1 : static_cast<double>(k) / (frames - 1));
  return times;
}

}  // namespace blossom::morphology
