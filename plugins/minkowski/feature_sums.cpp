#include "feature/registry.h"
#include "feature_types.h"
#include "geometry/planar/sums/set_operations.h"
#include "region_inputs.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

struct SumParameters {
  Value tolerance;              ///< null: follows the shapes' sizes
  std::vector<double> weights;  ///< of a sum
  bool keepDegenerate = false;  ///< of differences
};

FeatureBuilder<SumParameters> sumBuilder(std::string id, std::string title, std::string summary, std::string inputHelp,
                                         std::vector<ShapeKind> kinds, std::string asks,
                                         std::size_t mostShapes = anyNumber) {
  using P = SumParameters;
  auto builder = feature<P>(std::move(id), std::move(title), std::move(summary));
  builder
      .input({.name = "shape",
              .help = std::move(inputHelp),
              .kinds = std::move(kinds),
              .minimum = 2,
              .maximum = mostShapes,
              .use = InputUse::Control,
              .asks = std::move(asks)})
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them.");
  return builder;
}

constexpr const char* keepHelp =
    "Keep room without width, where the shape just fits: curves and points, which make the result a drawing.";

RegionSumOptions optionsOf(const SumParameters& p, std::size_t maximumWork) {
  return {toleranceOf(p.tolerance), maximumWork, p.weights, p.keepDegenerate};
}

/// A new one changes nothing.
ParameterSpec weight() {
  ParameterSpec spec = number();
  spec.fallback = 1.0;
  return spec;
}

}  // namespace

FeatureType sumFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.minkowski-sum", "Minkowski sum",
                    "The area that one shape covers while its origin moves over the other.",
                    "The shapes that are added: outlines, open curves, along which the others are swept, and points.",
                    setKinds, "a region, curves or a point to add")
      .icon("minkowski-sum")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .parameter("weights", &SumParameters::weights, onePer(list(weight()), "shape"),
                 "Factor of each shape about the origin, first to last; a negative one reflects in the origin, 0 leaves the "
                 "shape out. Others are 1.")
      .example("blossom minkowski-sum part.svg circle:2 -o grown.svg")
      .example("blossom minkowski-sum rectangle:40:10 polygon:6:5 -o sum.dxf --json")
      .example("blossom minkowski-sum part.svg part.svg --weights 1,-1 -o symmetric.svg")
      .example("blossom minkowski-sum path.dxf circle:3 -o groove.dxf")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        return evaluatedSet(setSum(setsOf(inputs), optionsOf(p, maximumWork), progress));
      });
}

FeatureType differenceFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.minkowski-difference", "Minkowski difference",
                    "All positions of the second shape's origin for which it stays inside the first.",
                    "A shape with an area, then what has to fit inside: an outline, open curves or points.", setKinds,
                    "a region, or what has to fit inside")
      .icon("minkowski-difference")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .parameter("keep-degenerate", &SumParameters::keepDegenerate, flag(), keepHelp)
      .example("blossom minkowski-difference pocket.svg circle:2 -o reach.svg")
      .example("blossom minkowski-difference rectangle:40:30 rectangle:10:10 --json")
      .example("blossom minkowski-difference slot.dxf circle:2 --keep-degenerate -o path.dxf")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        return evaluatedSet(setDifference(setsOf(inputs), optionsOf(p, maximumWork), progress));
      });
}

FeatureType openingFeature(std::size_t maximumWork) {
  return sumBuilder(
             "minkowski.region-open", "Opening of an outline",
             "The part of an outline that a shape covers while it stays inside: thin parts and outer corners disappear.",
             "An outline, then the shape that moves inside it.", {ShapeKind::Region}, "a region to combine", 2)
      .command("region-open")
      .icon("solid-open")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .parameter("keep-degenerate", &SumParameters::keepDegenerate, flag(), keepHelp)
      .example("blossom region-open plate.dxf circle:2 -o rounded.dxf")
      .example("blossom region-open star:5:20:12 circle:1 --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        const std::vector<PlanarSet> shapes = setsOf(inputs);
        return evaluatedSet(setOpening(shapes[0], shapes[1], optionsOf(p, maximumWork), progress));
      });
}

FeatureType closingFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.region-close", "Closing of an outline",
                    "An outline with the places filled that a shape cannot reach from outside: slots and inner corners.",
                    "An outline, then the shape that moves outside it, turned by 180 degrees.", {ShapeKind::Region},
                    "a region to combine", 2)
      .command("region-close")
      .icon("solid-close")
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .parameter("keep-degenerate", &SumParameters::keepDegenerate, flag(), keepHelp)
      .example("blossom region-close plate.dxf circle:2 -o filled.dxf")
      .example("blossom region-close star:5:20:12 circle:1 --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        const std::vector<PlanarSet> shapes = setsOf(inputs);
        return evaluatedSet(setClosing(shapes[0], shapes[1], optionsOf(p, maximumWork), progress));
      });
}

}  // namespace blossom::minkowski
