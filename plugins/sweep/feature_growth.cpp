#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "core/error.h"
#include "core/parallel.h"
#include "feature_types.h"
#include "geometry/shape/sequence.h"
#include "isolate/in_worker.h"
#include "kernel/edit/growth.h"
#include "kernel/motion_mesh.h"
#include "kernel/product_surface.h"
#include "kernel/solid.h"
#include "type_ids.h"
#include "validity_report.h"

namespace blossom::sweep {

namespace {

enum class GrowAs { Mesh, Surface, Solid };

struct GrowthParameters {
  double t = 0.5;
  int frames = 0;
  GrowAs as = GrowAs::Mesh;
  int cells = 6;
};

MotionMeshOptions meshOptionsOf(const GrowthParameters& p) { return {static_cast<std::size_t>(p.cells)}; }

std::size_t countOf(const GrowthParameters& p) { return static_cast<std::size_t>(std::max(p.frames, 1)); }

/// Cells of a mesh, or poles of a surface.
std::size_t sizeOf(const Motion& motion, const GrowthParameters& p) {
  if (p.as == GrowAs::Mesh) return cellsOfMesh(motion, meshOptionsOf(p));
  const PatchGrid grid = productGrid(motion);
  const auto poles = [](const ProductKnots& along) {
    return along.knots.size() - static_cast<std::size_t>(along.degree) - 1;
  };
  return poles(grid.u()) * poles(grid.v());
}

/// All frames are held in memory. Edits of finer levels give a motion more spans on its way, so every frame counts by
/// itself.
void requireRoom(const std::vector<GrowthStep>& steps, const GrowthParameters& p) {
  constexpr std::size_t mostCells = std::size_t{1} << 24, mostPoles = std::size_t{1} << 25;
  std::size_t most = 0;
  for (const GrowthStep& step : steps) most = std::max(most, std::max(sizeOf(step.from, p), sizeOf(step.to, p)));
  const bool mesh = p.as == GrowAs::Mesh;
  if (most <= (mesh ? mostCells : mostPoles) / countOf(p)) return;
  throw Error(ErrorCode::LimitExceeded,
              mesh ? "The meshes of all frames together would have more than 33 million triangles."
                   : "The surfaces of all frames together would have more than 33 million poles.",
              mesh ? "Ask for fewer frames or cells." : "Ask for fewer frames, or for meshes.");
}

Shape shapeOf(const Motion& motion, const GrowthParameters& p, const Progress& progress) {
  if (p.as == GrowAs::Mesh) return motionMesh(motion, meshOptionsOf(p), progress);
  Surface surface = productSurface(motion, {}, progress).surface;
  if (p.as == GrowAs::Surface) return surface;
  const SolidResult solid = makeSolid(surface, progress);
  refuseHollowRing(motion, solid, progress);
  return Brep(solid.solid);
}

double timeOf(const GrowthParameters& p, std::size_t frame) {
  if (p.frames == 0) return p.t;
  return p.frames == 1 ? 1 : static_cast<double>(frame) / (p.frames - 1);
}

GrowthPlace placeOf(const GrowthParameters& p, std::size_t frame, std::size_t steps) {
  if (p.frames < 2) return growthPlace(timeOf(p, frame), steps);
  return growthPlace(frame, static_cast<std::size_t>(p.frames), steps);
}

/// What is wrong on the way is not seen at its ends.
Shape frameOf(const std::vector<GrowthStep>& steps, const GrowthParameters& p, std::size_t frame, const Progress& progress) {
  const GrowthPlace place = placeOf(p, frame, steps.size());
  try {
    return shapeOf(grown(steps[place.step], place.share, progress), p, progress);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
    throw Error(error.code(), fmt::format("At t = {:.3g} of the way: {}", timeOf(p, frame), error.message()), error.hint());
  }
}

std::vector<Shape> framesOf(const std::vector<GrowthStep>& steps, const GrowthParameters& p, const Progress& progress) {
  std::vector<Shape> frames(countOf(p));
  const Progress cancelOnly(progress.token());
  std::atomic<std::size_t> done = 0;
  const auto make = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      frames[k] = frameOf(steps, p, k, cancelOnly);
      progress.report(static_cast<double>(++done) / static_cast<double>(frames.size()), "Growing");
    }
  };
  if (p.as == GrowAs::Solid)  // OCCT divides each solid among the cores itself
    make(0, frames.size());
  else
    parallelFor(frames.size(), 1, progress, make);
  return frames;
}

Evaluated evaluateGrowth(const GrowthParameters& p, const Inputs& inputs, const Progress& progress) {
  std::vector<Motion> following;
  validate(inputs.get<Motion>());
  for (std::size_t k = 0; k < inputs.of(1).size(); ++k) {
    validate(inputs.get<Motion>(1, k));
    following.push_back(inputs.get<Motion>(1, k));
  }
  const std::vector<GrowthStep> steps = growthSteps(inputs.get<Motion>(), following, progress.part(0, 0.1));
  requireRoom(steps, p);
  std::vector<Shape> frames = framesOf(steps, p, progress.part(0.1, 1));
  Evaluated out;
  out.stats["steps"] = steps.size();
  if (p.frames == 0) {
    out.shape = std::move(frames.front());
    return out;
  }
  Sequence sequence;
  for (std::size_t k = 0; k < frames.size(); ++k) sequence.times.push_back(timeOf(p, k));
  sequence.frames = std::move(frames);
  out.shape = std::move(sequence);
  return out;
}

InputSpec beginning() {
  return {.name = "motion",
          .help = "The motion that grows, before its edits; those of its file come first.",
          .kinds = {ShapeKind::Motion},
          .use = InputUse::Step,
          .asks = "the motion to begin with"};
}

InputSpec whatFollows() {
  return {.name = "following",
          .help = "What becomes of it, in order: every pull and twist after it.",
          .kinds = {ShapeKind::Motion},
          .minimum = 0,
          .maximum = anyNumber,
          .use = InputUse::Step,
          .asks = "the pulls and twists after it"};
}

}  // namespace

FeatureType growthFeature() {
  using P = GrowthParameters;
  FeatureType type =
      feature<P>(growthType, "Growth",
                 "The surfaces on the way of a motion through its pulls and twists, carried out one after another.")
          .command("sweep-growth")
          .icon("sequence")
          .produces({ShapeKind::Mesh, ShapeKind::Surface, ShapeKind::Brep})
          .playedBy({.parameter = "frames"})
          .byOutput({"as", {{"step stp iges igs brep", "surface"}, {"stl obj off ply 3mf", "mesh"}}})
          .keywords({"animation", "timeline", "scrub edits"})
          .input(beginning())
          .input(whatFollows())
          .parameter("t", &P::t, ratio(), "Part of the way, from 0 (before the edits) to 1 (after the last one).")
          .parameter("frames", &P::frames, count(0, 1000),
                     "Number of shapes of a sequence from 0 to 1; 0 makes the one at t.")
          .parameter("as", &P::as, choice({"mesh", "surface", "solid"}),
                     "What is made: triangles with their corners on the surface, the exact surface, or the solid in it.")
          .parameter("cells", &P::cells, onlyFor(count(1, 64), "as", {"mesh"}),
                     "Of a mesh: cells in each direction of every span of the control net.")
          .example("blossom sweep-growth edited.json --frames 25 -o frame.stl")
          .example("blossom sweep-growth hub.json blades.json propeller.json --frames 21 -o frame.step")
          .example("blossom sweep-growth hub.json propeller.json --t 0.7 --as solid -o between.step")
          .evaluate(evaluateGrowth);
  return inWorker(std::move(type),
                  {.activity = "for the solids of the growth", .when = [](const Value& parameters, const Inputs&) {
                     const auto as = parameters.find("as");
                     return as != parameters.end() && *as == Value("solid");
                   }});
}

}  // namespace blossom::sweep
