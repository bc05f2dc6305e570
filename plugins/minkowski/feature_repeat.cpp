#include "feature/registry.h"
#include "feature_types.h"
#include "kernel/region_repeat.h"
#include "region_inputs.h"

namespace blossom::minkowski {
namespace {

struct RepeatParameters {
  int count = 2;
  bool normalised = false;
  Value tolerance;  ///< null: follows the shape's size
};

struct HullParameters {
  Value tolerance;  ///< null: follows the shape's size
};

Evaluated repeatedShape(const RepeatParameters& p, std::size_t maximumWork, const Inputs& inputs, const Progress& progress) {
  RegionRepeatResult result = regionRepeat(regionsOf(inputs).front(),
                                           {.count = static_cast<std::size_t>(p.count),
                                            .normalised = p.normalised,
                                            .tolerance = toleranceOf(p.tolerance),
                                            .maximumWork = maximumWork},
                                           progress);
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.stats["hull_distance"] = result.hullDistance;
  out.stats["hull_bound"] = result.hullBound;
  out.stats["is_hull"] = result.isHull;
  out.warnings = std::move(result.warnings);
  out.shape = std::move(result.region);
  return out;
}

InputSpec oneShape(std::string help, std::string asks) {
  return {.name = "shape",
          .help = std::move(help),
          .kinds = {ShapeKind::Region},
          .use = InputUse::Control,
          .asks = std::move(asks)};
}

}  // namespace

FeatureType repeatFeature(std::size_t maximumWork) {
  using P = RepeatParameters;
  return feature<P>("minkowski.region-repeat", "Repeated sum",
                    "A shape added to itself several times, which fills towards its convex hull.")
      .icon("minkowski-sum")
      .produces({ShapeKind::Region})
      .input(oneShape("The shape that is added to itself.", "a shape to repeat"))
      .parameter("count", &P::count, count(1, 1'000'000'000), "How many copies are added.")
      .parameter("normalised", &P::normalised, flag(),
                 "Divide by the count: the result lies between the shape and its convex hull, the nearer to the hull the "
                 "more copies there are.")
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between curves and the polygons that stand for them. Once the convex hull is within it, "
                 "the hull is the result.")
      .example("blossom region-repeat star:5:20:8 --count 3 -o three.svg")
      .example("blossom region-repeat star:5:20:8 --count 10 --normalised -o fuller.svg --json")
      .evaluate([maximumWork](const P& p, const Inputs& inputs, const Progress& progress) {
        return repeatedShape(p, maximumWork, inputs, progress);
      });
}

FeatureType hullFeature(std::size_t) {
  using P = HullParameters;
  return feature<P>("minkowski.region-hull", "Convex hull",
                    "The smallest convex outline around a shape; its arcs stay arcs, and lines touch them.")
      .icon("outline")
      .produces({ShapeKind::Region})
      .input(oneShape("The shape to enclose, of one or several parts.", "a shape to enclose"))
      .parameter("tolerance", &P::tolerance, toleranceSpec(),
                 "Largest distance between free-form curves and the splines that stand for them.")
      .keywords({"rubber band", "envelope"})
      .example("blossom region-hull star:5:20:8 -o pentagon.svg")
      .example("blossom region-hull plate.dxf -o band.dxf --json")
      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
        Evaluated out;
        out.shape = regionHull(regionsOf(inputs).front(), toleranceOf(p.tolerance), progress);
        return out;
      });
}

}  // namespace blossom::minkowski
