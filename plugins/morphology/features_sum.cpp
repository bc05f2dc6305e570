#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "feature_groups.h"
#include "isolate/in_worker.h"

namespace blossom::morphology {

namespace {

struct SumParameters {
  double deviation = 0.05;
};

using PairOperation = std::function<MorphologyResult(const Operand&, const Operand&, const Progress&)>;

Evaluated combined(const PairOperation& operation, bool solidFirst, const SumParameters& p, const Inputs& inputs,
                   const Progress& progress) {
  const Operand a = operandOf(inputs.of(0)[0], {p.deviation, "The first shape", solidFirst}, progress.part(0, 0.05));
  const Operand b = operandOf(inputs.of(1)[0], {p.deviation, "The second shape", false}, progress.part(0.05, 0.1));
  return evaluatedFrom(operation(a, b, progress.part(0.1, 1)));
}

enum class ShownFacets { None, Families, Outlines };

struct ShownSumParameters {
  double deviation = 0.05;
  ShownFacets facets = ShownFacets::None;
  int preview = 0;
};

/// More lines, or more faces that are drawn anew with each picture, hide the shape and hold up the window.
std::size_t mostShown(ShownFacets shown) { return shown == ShownFacets::Outlines ? 4000 : 20000; }

/// {"corner_and_face": [[[x, y, z], ..], ..], ..}; and where the reflex corners are. Of too many facets only some are told.
void tellParts(const SumParts& parts, ShownFacets shown, Evaluated& out) {
  std::size_t total = 0;
  for (const auto& family : parts.facets) total += family.size();
  const std::size_t every = std::max<std::size_t>(1, (total + mostShown(shown) - 1) / mostShown(shown));
  if (every > 1)
    out.warnings.push_back(
        fmt::format("The picture shows one in {} of the {} facets that the sum is made of.", every, total));
  const auto coordinates = [](const std::vector<Vec3>& points) {
    Value all = Value::array();
    for (const Vec3& p : points) all.push_back({p.x(), p.y(), p.z()});
    return all;
  };
  constexpr std::array<const char*, 3> families{"corner_and_face", "face_and_corner", "edges"};
  Value facets = Value::object();
  for (std::size_t family = 0; family < families.size(); ++family) {
    Value& told = facets[families[family]] = Value::array();
    for (std::size_t k = 0; k < parts.facets[family].size(); k += every)
      told.push_back(coordinates(parts.facets[family][k]));
  }
  out.stats["parts"] = {{"facets", std::move(facets)}, {"reflex", coordinates(parts.reflex)}};
}

Evaluated summed(const ShownSumParameters& p, const Inputs& inputs, const Progress& progress) {
  if (p.preview > 0) {
    const auto previewed = [&](const Operand& a, const Operand& b, const Progress& part) {
      const bool anySolid = a.form == Operand::Form::Body || b.form == Operand::Form::Body;
      return anySolid ? previewOfSum({a, b}, {1, 1}, p.preview, {}, part) : solidSum(a, b, part);
    };
    return combined(previewed, false, {p.deviation}, inputs, progress);
  }
  const bool isPlain = p.facets == ShownFacets::None;
  Evaluated out = combined(solidSum, false, {p.deviation}, inputs, progress.part(0, isPlain ? 1 : 0.6));
  if (isPlain) return out;
  const auto operand = [&](std::size_t slot, const char* name) {
    return operandOf(inputs.of(slot)[0], {p.deviation, name, false}, progress.part(0.6, 0.7));
  };
  tellParts(partsOfSum(operand(0, "The first shape"), operand(1, "The second shape"), progress.part(0.7, 1)), p.facets, out);
  return out;
}

FeatureType sumFeature() {
  using P = ShownSumParameters;
  return feature<P>("morphology.solid-sum", "Solid sum",
                    "The space that one solid covers while its origin moves over the other.")
      .icon("solid-sum")
      .produces({ShapeKind::Mesh})
      .previewedBy("preview")
      .input({.name = "solid",
              .help = "The shape to add to.",
              .kinds = elementKinds,
              .use = InputUse::Consumed,
              .asks = "a shape to add to"})
      .input({.name = "element",
              .help = "The shape to add: a solid, a ball, a segment, a flat polygon or points.",
              .kinds = elementKinds,
              .use = InputUse::Consumed,
              .asks = "a shape to add"})
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp)
      .parameter("facets", &P::facets, choice({"none", "families", "outlines"}),
                 "What the picture shows of how the sum is made: the facets coloured by what they are made of, with the "
                 "reflex corners, and also the outlines of all facets, of which those inside are left out.")
      .parameter("preview", &P::preview, previewCells(), previewHelp)
      .example("blossom solid-sum part.stl ball:2 -o grown.stl")
      .example("blossom solid-sum bracket.step ball:1:2 --deviation 0.1 -o grown.off --json")
      .example("blossom solid-sum part.stl segment:0:0:20 -o swept.obj")
      .evaluate(summed);
}

struct PairTexts {
  const char *id, *title, *summary, *element, *icon, *activity;
  std::vector<const char*> examples;
};

FeatureType melting(const PairTexts& texts, const PairOperation& operation) {
  using P = SumParameters;
  auto made = feature<P>(texts.id, texts.title, texts.summary);
  made.icon(texts.icon)
      .produces({ShapeKind::Mesh})
      .input({.name = "solid",
              .help = "The solid that is changed.",
              .kinds = solidKinds,
              .use = InputUse::Consumed,
              .asks = "a solid to change"})
      .input({.name = "element",
              .help = texts.element,
              .kinds = elementKinds,
              .use = InputUse::Consumed,
              .asks = "a shape to change it with"})
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp);
  for (const char* example : texts.examples) made.example(example);
  return inWorker(made.evaluate([operation](const P& p, const Inputs& inputs, const Progress& progress) {
    return combined(operation, true, p, inputs, progress);
  }),
                  {.activity = texts.activity});
}

FeatureType differenceFeature() {
  return melting({"morphology.solid-difference",
                  "Solid difference",
                  "All positions of the second shape's origin for which it stays inside the first.",
                  "The shape that has to fit inside.",
                  "solid-difference",
                  "for the difference",
                  {"blossom solid-difference housing.stl ball:3 -o room.stl",
                   "blossom solid-difference block.step tool.step -o reach.off --json"}},
                 solidDifference);
}

FeatureType openFeature() {
  return melting({"morphology.solid-open",
                  "Opening",
                  "The part of a solid that a shape covers while it stays inside: thin walls and outer edges disappear.",
                  "The shape that moves inside the solid.",
                  "solid-open",
                  "for the opening",
                  {"blossom solid-open part.stl ball:1 -o rounded.stl"}},
                 solidOpening);
}

FeatureType closeFeature() {
  return melting({"morphology.solid-close",
                  "Closing",
                  "A solid with the places filled that a shape cannot reach from outside: narrow slots and inner edges.",
                  "The shape that moves outside the solid.",
                  "solid-close",
                  "for the closing",
                  {"blossom solid-close part.stl ball:1 -o filled.stl"}},
                 solidClosing);
}

struct RoundParameters {
  double radius = 1;
  RoundedEdges edges = RoundedEdges::Both;
  int subdivisions = 2;
  double deviation = 0.05;
};

Evaluated rounded(const RoundParameters& p, const Inputs& inputs, const Progress& progress) {
  const Operand solid = operandOf(inputs.of(0)[0], {p.deviation, "The solid", true}, progress.part(0, 0.1));
  BallResult made = ball({p.radius, p.subdivisions});
  Operand element;
  element.name = "The ball";
  element.mesh = std::move(made.mesh);
  Evaluated out = evaluatedFrom(solidRounded(solid, element, p.edges, progress.part(0.1, 1)));
  out.stats["ball_deviation"] = made.deviation;
  return out;
}

FeatureType roundFeature() {
  using P = RoundParameters;
  auto made = feature<P>("morphology.solid-round", "Round solid",
                         "A solid whose edges and corners are all rounded by a ball, as far as there is room for it.");
  made.icon("solid-round")
      .produces({ShapeKind::Mesh})
      .input({.name = "solid",
              .help = "The solid that is changed.",
              .kinds = solidKinds,
              .use = InputUse::Consumed,
              .asks = "a solid to round"})
      .parameter("radius", &P::radius, ballRadius(), "Radius of the ball.")
      .parameter("edges", &P::edges, choice({"convex", "reflex", "both"}),
                 "Which edges are rounded: outer ones, inner ones, or both. Thin walls go with the outer ones, narrow slots "
                 "with the inner ones.")
      .parameter("subdivisions", &P::subdivisions, count(0, maximumSubdivisions),
                 "Fineness of the ball: 20 faces, with each subdivision four times as many.")
      .parameter("deviation", &P::deviation, positiveLength(), deviationHelp)
      .example("blossom solid-round part.stl --radius 2 -o rounded.stl")
      .example("blossom solid-round bracket.step --radius 1 --edges convex --subdivisions 3 -o rounded.off --json");
  return inWorker(made.evaluate(rounded), {.activity = "for the rounding"});
}

}  // namespace

void registerSums(Registry& registry) {
  registry.addAll(inWorker(sumFeature(), {.activity = "for the sum"}), differenceFeature(), openFeature(), closeFeature(),
                  roundFeature());
}

}  // namespace blossom::morphology
