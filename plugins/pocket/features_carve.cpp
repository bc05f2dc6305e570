#include "core/error.h"
#include "feature_groups.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/setup.h"
#include "kernel/setup/stock_mesh.h"
#include "kernel/setup/stock_sweep.h"
#include "shape_triangles.h"

namespace blossom::pocket {

namespace {

struct CarveParameters {
  double until = 1;
  int frames = 0;
  int cells = 40'000;
};

constexpr int mostCells = 1'000'000;

Evaluated carved(const CarveParameters& p, const Inputs& inputs, const Progress& progress) {
  const auto& path = inputs.get<Toolpath>(0);
  const auto& setup = *inputs.of(1)[0].get<Setup>();
  if (setup.stock.empty())
    throw Error(ErrorCode::InvalidInput, "The setup has no stock to cut.", "Make a setup with the stock around the part.");
  StockField stock(bounds(setup.stock.at(0)), static_cast<std::size_t>(p.cells));
  stock.lowerTo(trianglesOf(setup.stock[0], progress.part(0, 0.1)));
  const double before = stock.volume();
  Evaluated out;
  out.stats["cell_mm"] = stock.cell();
  if (p.frames < 2) {
    cutBetween(stock, path, 0, p.until, progress.part(0.1, 1));
    out.shape = meshOf(stock);
  } else {
    Sequence sequence;
    for (int k = 0; k < p.frames; ++k) {
      const double last = p.frames - 1, time = k / last;
      const Progress part = progress.part(0.1 + 0.9 * k / (last + 1), 0.1 + 0.9 * (k + 1) / (last + 1));
      if (k > 0) cutBetween(stock, path, (k - 1) / last * p.until, time * p.until, part);
      sequence.frames.emplace_back(meshOf(stock));
      sequence.times.push_back(time);
    }
    out.shape = std::move(sequence);
  }
  out.stats["removed_mm3"] = before - stock.volume();
  return out;
}

}  // namespace

FeatureType carveFeature() {
  using P = CarveParameters;
  return feature<P>("pocket.carve", "Carve", "The stock as a program leaves it, or has left it so far.")
      .icon("carve")
      .keywords({"simulation", "stock", "material", "watch", "verify"})
      .produces({ShapeKind::Mesh})
      .playedBy({.parameter = "frames"})
      .input({.name = "program",
              .help = "A toolpath or a G-code program, from the work's zero of the setup.",
              .kinds = {ShapeKind::Toolpath},
              .asks = "a program to watch",
              .importedWith = {{"gcode", {{"as", "toolpath"}}}}})
      .input({.name = "setup",
              .help = "The stock, and where it stands.",
              .kinds = {ShapeKind::Setup},
              .use = InputUse::Consumed,
              .asks = "the setup that it runs in"})
      .parameter("until", &P::until, ratio(), "How far the program has gone, as a share of its time.")
      .parameter("frames", &P::frames, count(0, 1000),
                 "Number of shapes of a sequence from the whole stock on; 0 makes only the last one.")
      .parameter("cells", &P::cells, count(100, mostCells), "How many cells the stock is divided into, seen from above.")
      .example("blossom carve plate.ngc --setup job.blossom#setup -o left.stl --json")
      .example("blossom carve plate.ngc --setup job.blossom#setup --frames 60 -o cutting.ogv")
      .evaluate(carved);
}

}  // namespace blossom::pocket
