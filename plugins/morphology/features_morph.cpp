#include "feature_groups.h"
#include "isolate/in_worker.h"
#include "kernel/control.h"

namespace blossom::morphology {

namespace {

struct MorphParameters {
  double t = 0.5;
  int frames = 0;
  Control control = Control::Linear;
  Value curve = Value::array();
  double deviation = 0.05;
};

std::vector<ControlPoint> pointsOf(const Value& curve) {
  std::vector<ControlPoint> points;
  for (const Value& pair : curve) points.push_back({pair.at(0).get<double>(), pair.at(1).get<double>()});
  return points;
}

ParameterSpec unitCurve() {
  ParameterSpec spec = controlCurve();
  spec.minimum = 0;
  spec.maximum = 1;
  return spec;
}

Evaluated morphed(const MorphParameters& p, const Inputs& inputs, const Progress& progress) {
  const Operand a = operandOf(inputs.of(0)[0], {p.deviation, "The first solid", true}, progress);
  const Operand b = operandOf(inputs.of(1)[0], {p.deviation, "The second solid", true}, progress);
  const std::vector<double> times = p.frames > 0 ? frameTimes(p.frames) : std::vector<double>{p.t};
  const std::vector<ControlPoint> points = pointsOf(p.curve);
  std::vector<double> weights;
  weights.reserve(times.size());
  for (const double t : times) weights.push_back(controlValue(p.control, points, t));
  Evaluated out = evaluatedFrom(solidMorph(a, b, weights, progress), p.frames > 0 ? times : std::vector<double>());
  out.stats["weights"] = weights;
  return out;
}

FeatureType morphFeature() {
  using P = MorphParameters;
  const std::vector<ShapeKind> kinds{ShapeKind::Mesh, ShapeKind::Brep};
  return feature<P>("morphology.solid-morph", "Solid morph",
                    "The in-between solids of two solids with any numbers of holes and corners.")
      .icon("solid-morph")
      .produces({ShapeKind::Mesh})
      .playedBy({.parameter = "frames"})
      .input({.name = "from",
              .help = "The solid at t = 0.",
              .kinds = kinds,
              .use = InputUse::Control,
              .asks = "a solid to begin with"})
      .input({.name = "to",
              .help = "The solid at t = 1.",
              .kinds = kinds,
              .use = InputUse::Control,
              .asks = "a solid to end with"})
      .parameter("t", &P::t, ratio(), "Position along the morph, from 0 (the first solid) to 1 (the second).")
      .parameter("frames", &P::frames, count(0, 1000), "Number of solids of a sequence from 0 to 1; 0 makes the one at t.")
      .parameter("control", &P::control, choice({"linear", "ease", "ease-in", "ease-out", "curve"}),
                 "Growth of the share of the second solid with t.")
      .parameter("curve", &P::curve, onlyFor(unitCurve(), "control", {"curve"}),
                 "The share of the second solid at times t, when control is curve; linear between them.")
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp)
      .example("blossom solid-morph cube.off star.off --t 0.3 -o between.stl")
      .example("blossom solid-morph a.step b.step --frames 9 --control ease -o frame.obj")
      .example("blossom solid-morph a.stl b.stl --frames 5 --control curve --curve 0:0,0.5:0.9,1:1 -o frame.off")
      .evaluate(morphed);
}

}  // namespace

void registerMorph(Registry& registry) { registry.add(inWorker(morphFeature(), {.activity = "for the morph"})); }

}  // namespace blossom::morphology
