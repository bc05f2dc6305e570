#include "feature/registry.h"
#include "feature_types.h"
#include "kernel/outline_sweep.h"
#include "region_inputs.h"

namespace blossom::minkowski {
namespace {

struct OutlineSweepParameters {
  Boundary along = Boundary::All;
  Value tolerance;  ///< null: follows the shapes' sizes
};

}  // namespace

FeatureType outlineSweepFeature(std::size_t maximumWork) {
  using P = OutlineSweepParameters;
  return feature<P>("minkowski.outline-sweep", "Sweep along an outline",
                    "The area that a shape covers while its origin runs along the boundary of another.")
      .command("outline-sweep")
      .icon("sweep-along")
      .produces({ShapeKind::Region})
      .input({.name = "shape",
              .help = "The shape whose boundary is followed, then the one that is swept.",
              .kinds = {ShapeKind::Region},
              .minimum = 2,
              .maximum = 2,
              .use = InputUse::Control,
              .asks = "a region to follow or to sweep"})
      .parameter("along", &P::along, choice({"all", "outer", "holes"}), "Which loops of the boundary are followed.")
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them.")
      .example("blossom outline-sweep plate.dxf circle:1 -o groove.dxf")
      .example("blossom outline-sweep flower.svg butterfly.svg --along holes -o swept.svg")
      .evaluate([maximumWork](const P& p, const Inputs& inputs, const Progress& progress) {
        const std::vector<Region> shapes = regionsOf(inputs);
        return evaluatedSum(outlineSweep(shapes[0], shapes[1], p.along, {toleranceOf(p.tolerance), maximumWork}, progress));
      });
}

}  // namespace blossom::minkowski
