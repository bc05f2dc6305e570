#include <fmt/format.h>

#include <array>

#include "core/error.h"
#include "feature_groups.h"
#include "isolate/in_worker.h"

namespace blossom::morphology {

namespace {

struct MorphParameters {
  double t = 0.5;
  int frames = 0;
  std::vector<double> blossom;
  Control control = Control::Linear;
  Value curve = straightControl();
  bool volumePreserving = false;
  double deviation = 0.05;
  int preview = 0;
};

/// Of each of n + 1 solids at n arguments: the blossom of the Bernstein polynomial, one product of t and 1 - t for every way
/// to choose.
std::vector<double> weightsAt(const std::vector<double>& arguments) {
  std::vector<double> weights{1};
  for (const double t : arguments) {
    weights.push_back(0);
    for (std::size_t k = weights.size(); k-- > 0;) weights[k] = (1 - t) * weights[k] + (k > 0 ? t * weights[k - 1] : 0);
  }
  return weights;
}

void checkBlossom(const MorphParameters& p, std::size_t solids) {
  if (p.blossom.empty()) return;
  if (p.frames > 0)
    throw Error(ErrorCode::InvalidParameter, "Blossom parameters give one solid, not a sequence of frames.",
                "Leave out the frames or the blossom parameters.");
  if (p.blossom.size() + 1 != solids)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("{} blossom parameters are given for {} solids.", p.blossom.size(), solids),
                fmt::format("Give {} of them: one for each solid after the first.", solids - 1));
}

/// "The first solid".
std::string nameOf(std::size_t solid) {
  constexpr std::array<const char*, 5> ordinals{"first", "second", "third", "fourth", "fifth"};
  return solid < ordinals.size() ? fmt::format("The {} solid", ordinals[solid]) : fmt::format("Solid {}", solid + 1);
}

std::vector<Operand> solidsOf(const Inputs& inputs, double deviation, const Progress& progress) {
  std::vector<Operand> solids;
  const double share = 1 / static_cast<double>(inputs.of(0).size());
  for (const Shape& shape : inputs.of(0)) {
    const double from = share * static_cast<double>(solids.size());
    solids.push_back(operandOf(shape, {deviation, nameOf(solids.size()), true}, progress.part(from, from + share)));
  }
  return solids;
}

Evaluated morphed(const MorphParameters& p, const Inputs& inputs, const Progress& progress) {
  const std::vector<Operand> solids = solidsOf(inputs, p.deviation, progress.part(0, 0.1));
  checkBlossom(p, solids.size());
  const std::vector<double> times = p.frames > 0 ? frameTimes(p.frames) : std::vector<double>{p.t};
  std::vector<std::vector<double>> weights;
  for (const double t : controlled(p.control, p.curve, times))
    weights.push_back(weightsAt(p.blossom.empty() ? std::vector<double>(solids.size() - 1, t) : p.blossom));
  const MorphOptions options{.volumePreserving = p.volumePreserving};
  if (p.preview > 0 && p.frames == 0)
    return evaluatedFrom(previewOfSum(solids, weights.front(), p.preview, options, progress.part(0.1, 1)));
  Evaluated out = evaluatedFrom(solidMorph(solids, weights, options, progress.part(0.1, 1)),
                                p.frames > 0 ? times : std::vector<double>());
  out.stats["weights"] = p.frames > 0 ? Value(weights) : Value(weights.front());
  return out;
}

FeatureType morphFeature() {
  using P = MorphParameters;
  return feature<P>("morphology.solid-morph", "Solid morph",
                    "The in-between solids of two or more solids with any numbers of holes and corners.")
      .icon("solid-morph")
      .produces({ShapeKind::Mesh})
      .playedBy({.parameter = "frames", .excludedBy = "blossom"})
      .previewedBy("preview")
      .input({.name = "solids",
              .help =
                  "Solids from t = 0 to t = 1; those between pull the morph towards them, as the poles of a Bezier curve "
                  "do.",
              .kinds = solidKinds,
              .minimum = 2,
              .maximum = anyNumber,
              .use = InputUse::Control,
              .asks = "solids to morph"})
      .parameter("t", &P::t, ratio(), "Position along the morph, from 0 (the first solid) to 1 (the last).")
      .parameter("frames", &P::frames, count(0, 1000), "Number of solids of a sequence from 0 to 1; 0 makes the one at t.")
      .parameter("blossom", &P::blossom, onePer(list(ratio()), "solids", -1, "t"),
                 "One number for each solid after the first, instead of t; all equal, they are t.")
      .parameter("control", &P::control, controlChoice(), "Growth of the share of later solids with t.")
      .parameter("curve", &P::curve, controlCurveSpec(),
                 "The value that takes the place of t at times t; linear between them.")
      .parameter("volume-preserving", &P::volumePreserving, flag(),
                 "Scale each solid about its middle so that its volume blends those of the shapes.")
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp)
      .parameter("preview", &P::preview, previewCells(), previewHelp)
      .example("blossom solid-morph cube.off star.off --t 0.3 -o between.stl")
      .example("blossom solid-morph a.step b.step c.step --frames 9 --control ease -o frame.obj")
      .example("blossom solid-morph a.stl b.stl c.stl --blossom 0.2,0.9 -o between.off")
      .example("blossom solid-morph a.stl b.stl --frames 5 --control curve --curve 0:0,0.5:0.9,1:1 -o frame.off")
      .evaluate(morphed);
}

}  // namespace

void registerMorph(Registry& registry) { registry.add(inWorker(morphFeature(), {.activity = "for the morph"})); }

}  // namespace blossom::morphology
