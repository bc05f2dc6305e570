#include <functional>

#include "feature_groups.h"
#include "isolate/in_worker.h"

namespace blossom::morphology {

namespace {

struct GrowParameters {
  double radius = 1;
  int frames = 0;
  int subdivisions = 1;
  BallFit fit = BallFit::Inscribed;
  double deviation = 0.05;
};

using GrowOperation = std::function<MorphologyResult(const Operand&, const GrowOptions&, const Progress&)>;

GrowOptions optionsOf(const GrowParameters& p, const std::vector<double>& times) {
  GrowOptions options{.radii = {p.radius}, .subdivisions = p.subdivisions, .fit = p.fit};
  if (!times.empty()) options.radii.clear();
  for (const double t : times) options.radii.push_back(t * p.radius);
  return options;
}

Evaluated grown(const GrowOperation& operation, const GrowParameters& p, const Inputs& inputs, const Progress& progress) {
  const Operand solid = operandOf(inputs.of(0)[0], {p.deviation, "The solid", true}, progress);
  const std::vector<double> times = frameTimes(p.frames);
  Evaluated out = evaluatedFrom(operation(solid, optionsOf(p, times), progress), times);
  out.stats["ball_deviation"] = ball({p.radius, p.subdivisions, p.fit}).deviation;
  return out;
}

struct GrowTexts {
  const char *id, *title, *summary, *radius, *icon;
  std::vector<const char*> examples;
};

FeatureType growth(const GrowTexts& texts, const GrowOperation& operation) {
  using P = GrowParameters;
  auto made = feature<P>(texts.id, texts.title, texts.summary);
  made.icon(texts.icon)
      .produces({ShapeKind::Mesh})
      .playedBy({.parameter = "frames"})
      .input({.name = "solid",
              .help = "The solid that is changed.",
              .kinds = {ShapeKind::Mesh, ShapeKind::Brep},
              .use = InputUse::Consumed,
              .asks = "a solid to grow or melt"})
      .parameter("radius", &P::radius, positiveLength(), texts.radius)
      .parameter("frames", &P::frames, count(0, 1000),
                 "Number of solids of a sequence from radius 0 to the radius; 0 makes only the last one.")
      .parameter("subdivisions", &P::subdivisions, count(0, maximumSubdivisions),
                 "Fineness of the ball: 20 faces, with each subdivision four times as many.")
      .parameter("fit", &P::fit, choice({"inscribed", "circumscribed"}),
                 "Whether the ball's polyhedron lies inside it or around it.")
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp);
  for (const char* example : texts.examples) made.example(example);
  return made.evaluate([operation](const P& p, const Inputs& inputs, const Progress& progress) {
    return grown(operation, p, inputs, progress);
  });
}

FeatureType inflateFeature() {
  return growth({"morphology.inflate",
                 "Inflate",
                 "A solid grown by a ball: every point within the radius of it.",
                 "Distance by which it grows.",
                 "inflate",
                 {"blossom inflate part.stl --radius 2 -o grown.stl",
                  "blossom inflate bracket.step --radius 1 --subdivisions 2 --fit circumscribed -o grown.off --json"}},
                inflated);
}

FeatureType meltFeature() {
  return growth(
      {"morphology.melt",
       "Melt",
       "A solid melted by a ball: every point farther than the radius from its outside.",
       "Depth by which it melts.",
       "melt",
       {"blossom melt part.stl --radius 2 -o core.stl", "blossom melt ice.step --radius 8 --frames 9 -o frame.obj"}},
      melted);
}

}  // namespace

void registerGrowth(Registry& registry) {
  registry.addAll(inWorker(inflateFeature(), {.activity = "for the inflating"}),
                  inWorker(meltFeature(), {.activity = "for the melting"}));
}

}  // namespace blossom::morphology
