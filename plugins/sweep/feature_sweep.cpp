#include "edit_values.h"
#include "feature_types.h"
#include "isolate/in_worker.h"
#include "kernel/cubic_approximation.h"
#include "kernel/edit/apply_edits.h"
#include "kernel/product_surface.h"
#include "kernel/solid.h"
#include "kernel/validity.h"
#include "type_ids.h"
#include "validity_report.h"

namespace blossom::sweep {

namespace {

enum class Mode { Exact, Cubic };

struct SweepParameters {
  bool solid = false;
  Mode mode = Mode::Exact;
  double tolerance = 1e-3;
};

const char* capName(EndCap cap) {
  switch (cap) {
    case EndCap::None:
      return "none";
    case EndCap::Point:
      return "point";
    case EndCap::Planar:
      return "planar";
    case EndCap::Edge:
      return "edge";
    case EndCap::Cone:
      return "cone";
  }
  return "none";
}

void addSurfaceStats(const Surface& surface, Value& stats) {
  stats["degree_u"] = surface.degreeU;
  stats["degree_v"] = surface.degreeV;
  stats["poles_u"] = surface.countU();
  stats["poles_v"] = surface.countV();
}

Surface exactSurface(const Motion& motion, Evaluated& out, const Progress& progress) {
  const ProductResult product = productSurface(motion, {}, progress);
  addSurfaceStats(product.surface, out.stats);
  out.stats["min_weight"] = product.smallestWeight;
  out.stats["refinements"] = product.refinements;
  if (product.refinements > 0)
    out.warnings.push_back(
        "Knots were inserted to keep every weight well above zero; the surface is the same, with more poles.");
  return product.surface;
}

Surface cubicSurface(const Motion& motion, double tolerance, Evaluated& out, const Progress& progress) {
  const CubicResult cubic = approximateCubic(motion, {.tolerance = tolerance}, progress);
  addSurfaceStats(cubic.surface, out.stats);
  out.stats["min_weight"] = 1.0;
  out.stats["deviation"] = cubic.deviation;
  out.stats["spans_u"] = cubic.spansU;
  out.stats["spans_v"] = cubic.spansV;
  return cubic.surface;
}

/// That of a cubic surface, which has been measured when it was made.
std::optional<double> measuredDeviation(const Evaluated& out) {
  const auto found = out.stats.find("deviation");
  return found == out.stats.end() ? std::nullopt : std::optional(found->get<double>());
}

Evaluated sweep(const SweepParameters& p, const Inputs& inputs, const Progress& progress) {
  const Motion& given = inputs.get<Motion>();
  validate(given);
  const Motion motion = withEditsApplied(given, progress);
  Evaluated out;
  if (!given.edits.empty()) out.stats["edits"] = given.edits.size();
  out.stats["mode"] = p.mode == Mode::Exact ? "exact" : "cubic";
  progress.report(0.02, "Sweeping");
  const Progress making = progress.part(0.05, p.solid ? 0.5 : 0.8);
  const Surface surface =
      p.mode == Mode::Exact ? exactSurface(motion, out, making) : cubicSurface(motion, p.tolerance, out, making);
  requireArea(motion, progress);
  if (!p.solid) {
    addValidity(motion, surface, measuredDeviation(out), out, progress.part(0.8, 1));
    out.shape = surface;
    return out;
  }
  // The solid is refused where it crosses itself or turns inside out, with the place.
  progress.report(0.55, "Closing the solid");
  const SolidResult solid = makeSolid(surface, progress.part(0.55, 0.95));
  out.stats["caps"] = Value::array({capName(solid.start), capName(solid.end)});
  if (solid.start == EndCap::Cone || solid.end == EndCap::Cone)
    out.warnings.push_back("An end of the sweep is not planar; it is closed by straight lines to its centre.");
  addValidityOfSolid(motion, surface, solid, measuredDeviation(out), out, progress.part(0.95, 1));
  out.shape = Brep(solid.solid);
  return out;
}

/// The edits of a motion file become features, so that each can be changed, left out and seen in the tree.
TakenApart editsTakenApart(const Shape& shape) {
  TakenApart apart;
  const Motion* motion = shape.get<Motion>();
  if (!motion || motion->edits.empty()) return apart;
  apart.importedWith = {{"motion", {{"edits", "left-out"}}}};
  for (const MotionEdit& edit : motion->edits) apart.steps.push_back(stepOf(edit));
  return apart;
}

}  // namespace

FeatureType sweepFeature() {
  using P = SweepParameters;
  FeatureType type =
      feature<P>(sweepType, "Sweep", "The exact surface or solid that one point sweeps under a motion in two parameters.")
          .command("sweep")
          .produces({ShapeKind::Surface, ShapeKind::Brep})
          .opens(ShapeKind::Motion)
          .takesApart(editsTakenApart)
          .input({.name = "motion",
                  .help = "A motion: trajectory, orientation and scaling, and its edits.",
                  .kinds = {ShapeKind::Motion},
                  .use = InputUse::Consumed,
                  .asks = "a motion to sweep with"})
          .parameter("solid", &P::solid, flag(), "Close the ends of a motion that closes in u and make a solid.")
          .parameter("mode", &P::mode, choice({"exact", "cubic"}),
                     "The exact rational surface, or a bicubic one within the tolerance.")
          .parameter("tolerance", &P::tolerance, onlyFor(positiveLength(), "mode", {"cubic"}),
                     "Largest deviation of the cubic surface, measured at equal parameters.")
          .example("blossom sweep propeller.json --solid -o propeller.step")
          .example("blossom sweep propeller.json --mode cubic --tolerance 0.01 -o propeller.iges")
          .example("blossom sweep helicoid.json -o helicoid.stl --json")
          .evaluate(sweep);
  // OCCT builds and meshes the solid: it cannot be cancelled everywhere, and may crash on what crosses itself.
  return inWorker(std::move(type),
                  {.activity = "for the solid of the sweep", .when = [](const Value& parameters, const Inputs&) {
                     const auto solid = parameters.find("solid");
                     return solid != parameters.end() && solid->get<bool>();
                   }});
}

}  // namespace blossom::sweep
