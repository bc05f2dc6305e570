#include "feature/registry.h"
#include "feature_types.h"
#include "kernel/region_sum.h"
#include "region_inputs.h"

namespace blossom::minkowski {
namespace {

struct SumParameters {
  Value tolerance;  ///< null: follows the shapes' sizes
};

FeatureBuilder<SumParameters> sumBuilder(std::string id, std::string title, std::string summary, std::string inputHelp,
                                         std::size_t mostShapes = anyNumber) {
  using P = SumParameters;
  auto builder = feature<P>(std::move(id), std::move(title), std::move(summary));
  builder
      .input({.name = "shape",
              .help = std::move(inputHelp),
              .kinds = {ShapeKind::Region},
              .minimum = 2,
              .maximum = mostShapes,
              .use = InputUse::Control,
              .asks = "a region to combine"})
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them.");
  return builder;
}

}  // namespace

FeatureType sumFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.minkowski-sum", "Minkowski sum",
                    "The area that one shape covers while its origin moves over the other.", "The shapes that are added.")
      .icon("minkowski-sum")
      .produces({ShapeKind::Region})
      .example("blossom minkowski-sum part.svg circle:2 -o grown.svg")
      .example("blossom minkowski-sum rectangle:40:10 polygon:6:5 -o sum.dxf --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        return evaluatedSum(minkowskiSum(regionsOf(inputs), {toleranceOf(p.tolerance), maximumWork}, progress));
      });
}

FeatureType differenceFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.minkowski-difference", "Minkowski difference",
                    "All positions of the second shape's origin for which it stays inside the first.",
                    "A shape, then the shape that has to fit inside.")
      .icon("minkowski-difference")
      .produces({ShapeKind::Region})
      .example("blossom minkowski-difference pocket.svg circle:2 -o reach.svg")
      .example("blossom minkowski-difference rectangle:40:30 rectangle:10:10 --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        return evaluatedSum(minkowskiDifference(regionsOf(inputs), {toleranceOf(p.tolerance), maximumWork}, progress));
      });
}

FeatureType openingFeature(std::size_t maximumWork) {
  return sumBuilder(
             "minkowski.region-open", "Opening of an outline",
             "The part of an outline that a shape covers while it stays inside: thin parts and outer corners disappear.",
             "An outline, then the shape that moves inside it.", 2)
      .command("region-open")
      .icon("solid-open")
      .produces({ShapeKind::Region})
      .example("blossom region-open plate.dxf circle:2 -o rounded.dxf")
      .example("blossom region-open star:5:20:12 circle:1 --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        const std::vector<Region> shapes = regionsOf(inputs);
        return evaluatedSum(regionOpening(shapes[0], shapes[1], {toleranceOf(p.tolerance), maximumWork}, progress));
      });
}

FeatureType closingFeature(std::size_t maximumWork) {
  return sumBuilder("minkowski.region-close", "Closing of an outline",
                    "An outline with the places filled that a shape cannot reach from outside: slots and inner corners.",
                    "An outline, then the shape that moves outside it, turned by 180 degrees.", 2)
      .command("region-close")
      .icon("solid-close")
      .produces({ShapeKind::Region})
      .example("blossom region-close plate.dxf circle:2 -o filled.dxf")
      .example("blossom region-close star:5:20:12 circle:1 --json")
      .evaluate([maximumWork](const SumParameters& p, const Inputs& inputs, const Progress& progress) {
        const std::vector<Region> shapes = regionsOf(inputs);
        return evaluatedSum(regionClosing(shapes[0], shapes[1], {toleranceOf(p.tolerance), maximumWork}, progress));
      });
}

}  // namespace blossom::minkowski
