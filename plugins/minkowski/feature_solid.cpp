#include "feature/registry.h"
#include "feature_types.h"
#include "kernel/solid/loft.h"
#include "kernel/solid/loft_brep.h"
#include "region_inputs.h"

namespace blossom::minkowski {
namespace {

struct SolidParameters {
  double height = 20;
  Value tolerance;  ///< null: follows the shapes' sizes
};

Evaluated solidBetween(const SolidParameters& p, std::size_t maximumWork, const Inputs& inputs, const Progress& progress) {
  const std::vector<Region> shapes = regionsOf(inputs);
  const LoftResult result =
      loft(shapes[0], shapes[1], {.height = p.height, .tolerance = toleranceOf(p.tolerance), .maximumWork = maximumWork},
           progress);
  Evaluated out;
  out.stats["facets"] = result.facets;
  out.shape = loftBrep(result.mesh, progress);
  return out;
}

}  // namespace

FeatureType solidFeature(std::size_t maximumWork) {
  using P = SolidParameters;
  return feature<P>("minkowski.morph-solid", "Morph as solid",
                    "The solid whose section at every height is the morph of two outlines, with planar faces.")
      .command("morph-solid")
      .icon("loft")
      .produces({ShapeKind::Brep})
      .input({.name = "shape",
              .help = "The outline at the bottom, then the one at the top.",
              .kinds = {ShapeKind::Region},
              .minimum = 2,
              .maximum = 2,
              .use = InputUse::Control,
              .asks = "an outline of the solid"})
      .parameter("height", &P::height, positiveLength(), "Distance of the second outline above the first.")
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them.")
      .example("blossom morph-solid star:5:20:8 circle:15 --height 30 -o vase.step")
      .example("blossom morph-solid ring.svg slot.svg --height 12 -o adapter.stl --json")
      .evaluate([maximumWork](const P& p, const Inputs& inputs, const Progress& progress) {
        return solidBetween(p, maximumWork, inputs, progress);
      });
}

}  // namespace blossom::minkowski
