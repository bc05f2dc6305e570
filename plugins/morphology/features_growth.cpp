#include "feature_groups.h"
#include "isolate/in_worker.h"

namespace blossom::morphology {

namespace {

enum class Until { Size, Nothing };

struct GrowParameters {
  double radius = 1;
  double size = 1;
  int frames = 0;
  Until until = Until::Size;
  double rounding = 0;
  Control control = Control::Linear;
  Value curve = straightControl();
  int subdivisions = 1;
  BallFit fit = BallFit::Inscribed;
  double deviation = 0.05;
};

using GrowOperation = MorphologyResult (*)(const Operand&, const GrowOptions&, const Progress&);

GrowOptions optionsOf(const GrowParameters& p, const Inputs& inputs, const std::vector<double>& times,
                      const Progress& progress) {
  GrowOptions options;
  options.subdivisions = p.subdivisions;
  options.fit = p.fit;
  options.rounding = p.rounding;
  options.untilNothing = p.until == Until::Nothing;
  if (!inputs.of(1).empty())
    options.element = operandOf(inputs.of(1)[0], {p.deviation, "The element", false}, progress.part(0.05, 0.1));
  const double whole = options.untilNothing ? 1 : options.element ? p.size : p.radius;
  options.sizes = times.empty() ? std::vector<double>{1} : controlled(p.control, p.curve, times);
  for (double& size : options.sizes) size *= whole;
  return options;
}

/// Says which values have no effect: those of the ball beside an element, that of an element beside the ball.
void warnOfUnused(const GrowParameters& p, bool byElement, Evaluated& out) {
  const GrowParameters unset;
  const bool isBallSet = p.radius != unset.radius || p.subdivisions != unset.subdivisions || p.fit != unset.fit;
  if (byElement && isBallSet)
    out.warnings.emplace_back(
        "Radius, subdivisions and fit have no effect: they are of the ball. An element is taken as drawn, as many times as "
        "large as `size` says.");
  if (!byElement && p.until == Until::Nothing && p.radius != unset.radius)
    out.warnings.emplace_back("The radius has no effect: the solid melts until nothing is left.");
  if (!byElement && p.size != unset.size)
    out.warnings.emplace_back("The size has no effect: it is of an element. The ball has its radius.");
}

Evaluated grown(GrowOperation operation, const GrowParameters& p, const Inputs& inputs, const Progress& progress) {
  const Operand solid = operandOf(inputs.of(0)[0], {p.deviation, "The solid", true}, progress.part(0, 0.05));
  const std::vector<double> times = frameTimes(p.frames);
  const GrowOptions options = optionsOf(p, inputs, times, progress);
  MorphologyResult made = operation(solid, options, progress.part(0.1, 1));
  const double largest = made.stats.largestSize;
  Evaluated out = evaluatedFrom(std::move(made), times);
  warnOfUnused(p, options.element.has_value(), out);
  if (options.untilNothing) out.stats[options.element ? "largest_size" : "largest_radius"] = largest;
  if (!options.element)
    out.stats["ball_deviation"] = ball({options.untilNothing ? largest : p.radius, p.subdivisions, p.fit}).deviation;
  return out;
}

struct GrowTexts {
  const char *id, *title, *summary, *element, *radius, *icon;
  std::vector<const char*> examples;
  bool canMeltToNothing = false;  ///< has `until`
};

FeatureBuilder<GrowParameters> growth(const GrowTexts& texts) {
  using P = GrowParameters;
  auto made = feature<P>(texts.id, texts.title, texts.summary);
  made.icon(texts.icon)
      .produces({ShapeKind::Mesh})
      .playedBy({.parameter = "frames"})
      .input({.name = "solid",
              .help = "The solid that is changed.",
              .kinds = solidKinds,
              .use = InputUse::Consumed,
              .asks = "a solid to grow or melt"})
      .input({.name = "element", .help = texts.element, .kinds = elementKinds, .minimum = 0, .use = InputUse::Control});
  const auto untilSize = [&](ParameterSpec spec) {
    return texts.canMeltToNothing ? onlyFor(std::move(spec), "until", {"size"}) : spec;
  };
  const auto ofBall = [](ParameterSpec spec) { return onlyWithout(std::move(spec), "element"); };
  if (texts.canMeltToNothing)
    made.parameter("until", &P::until, choice({"size", "nothing"}),
                   "How far it melts: by the radius or size, or as far as anything is left.");
  made.parameter("radius", &P::radius, ofBall(untilSize(ballRadius())), texts.radius)
      .parameter("size", &P::size, onlyWith(untilSize(positiveNumber()), "element"),
                 "How many times as large as drawn an element is taken.")
      .parameter("frames", &P::frames, count(0, 1000),
                 "Number of solids of a sequence from size 0 to the whole size; 0 makes only the last one.")
      .parameter("control", &P::control, controlChoice(), "Growth of the size over the frames.")
      .parameter("curve", &P::curve, controlCurveSpec(),
                 "The share of the whole size at times from 0 to 1; linear between them.")
      .parameter("subdivisions", &P::subdivisions, ofBall(count(0, maximumSubdivisions)),
                 "Fineness of the ball: 20 faces, with each subdivision four times as many.")
      .parameter("fit", &P::fit, ofBall(choice({"inscribed", "circumscribed"})),
                 "Whether the ball's polyhedron lies inside it or around it.")
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp);
  for (const char* example : texts.examples) made.example(example);
  return made;
}

FeatureType inflateFeature() {
  return growth({"morphology.inflate",
                 "Inflate",
                 "A solid grown by a ball or another shape: every point within the radius of it.",
                 "A shape to grow by in place of the ball, about the origin.",
                 "Distance by which it grows; of the ball.",
                 "inflate",
                 {"blossom inflate part.stl --radius 2 -o grown.stl",
                  "blossom inflate bracket.step --radius 1 --subdivisions 2 --fit circumscribed -o grown.off --json",
                  "blossom inflate part.stl diamond.off --size 0.5 -o grown.off"}})
      .evaluate([](const GrowParameters& p, const Inputs& inputs, const Progress& progress) {
        return grown(inflated, p, inputs, progress);
      });
}

FeatureType meltFeature() {
  using P = GrowParameters;
  return growth({"morphology.melt",
                 "Melt",
                 "A solid melted by a ball or another shape: every point farther than the radius from its outside.",
                 "A shape to melt by in place of the ball, about the origin.",
                 "Depth by which it melts; of the ball.",
                 "melt",
                 {"blossom melt part.stl --radius 2 -o core.stl", "blossom melt ice.step --radius 8 --frames 9 -o frame.obj",
                  "blossom melt ice.step --until nothing --rounding 0.5 --frames 12 --control ease-out -o frame.obj"},
                 true})
      .parameter("rounding", &P::rounding, ratio(),
                 "What is left is rounded by this share of the depth, as ice is: edges and thin places go first.")
      .evaluate(
          [](const P& p, const Inputs& inputs, const Progress& progress) { return grown(melted, p, inputs, progress); });
}

}  // namespace

void registerGrowth(Registry& registry) {
  registry.addAll(inWorker(inflateFeature(), {.activity = "for the inflating"}),
                  inWorker(meltFeature(), {.activity = "for the melting"}));
}

}  // namespace blossom::morphology
