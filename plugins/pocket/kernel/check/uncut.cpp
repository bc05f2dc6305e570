#include "kernel/check/uncut.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/parallel.h"
#include "geometry/planar/planar.h"
#include "kernel/check/floor_ways.h"
#include "kernel/check/uncut_cells.h"
#include "kernel/check/uncut_places.h"
#include "kernel/check/uncut_strips.h"

namespace blossom::pocket {

namespace {

class UncutSearch {
 public:
  UncutSearch(const Region& part, const Toolpath& path, const UncutOptions& options, const Progress& progress)
      : o_(options), ways_(floorWays(path, options.floor)), radius_(path.cutter.diameter / 2) {
    for (const Path& loop : part.loops) {
      partArea_ += signedArea(loop);
      perimeter_ += length(loop);
    }
    partArea_ = std::abs(partArea_);
    // Splines are taken as lines within this; the area of what lies between is at most chord times perimeter.
    constexpr double share = 4e-6;
    chord_ = share * partArea_ / perimeter_;
    UncutCell whole;
    for (const Path& loop : part.loops) {
      progress.check();
      for (const Stroke& stroke : strokesOf(loop, chord_)) addRims(stroke, whole.rims);
    }
    frame(whole);
    findCovers(progress);
    for (const UncutCover& cover : covers_)
      if (reaches(cover, whole)) whole.covers.push_back(&cover);
    findFineness(whole);
    UncutCells parted = uncutCells(std::move(whole), progress.part(0, 0.1));
    cells_ = std::move(parted.cells);
    steps_ = parted.steps;
  }

  Uncut search(const Progress& progress) {
    double boxes = 0;
    for (const UncutCell& cell : cells_) boxes += cell.area();
    constexpr double share = 2e-6;  // of the part's area, that the bounds may be apart
    const auto count = static_cast<double>(cells_.size());
    fine_.perBox = share / 2 * partArea_ / boxes;
    fine_.perCell = share / 2 * partArea_ / count;
    constexpr double maximumWork = 5e8, maximumWorkOfCell = 1e6;  // slabs processed
    fine_.work = std::min(maximumWorkOfCell, maximumWork / count);
    std::vector<std::vector<UncutStrip>> strips(cells_.size());
    std::vector<std::size_t> steps(cells_.size());
    std::atomic<std::size_t> done = 0;
    parallelFor(cells_.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        progress.report(0.9 * static_cast<double>(done++) / static_cast<double>(cells_.size()));
        UncutStrips found = uncutStrips(cells_[i], fine_, progress);
        strips[i] = std::move(found.strips);
        steps[i] = found.steps;
      }
    });
    Uncut uncut;
    uncut.partArea = partArea_;
    uncut.steps = std::accumulate(steps.begin(), steps.end(), steps_);
    double minimum = 0, maximum = 0;
    for (const auto& some : strips)
      for (const UncutStrip& strip : some) {
        minimum += strip.area.minimum;
        maximum += strip.area.maximum;
      }
    uncut.area = (minimum + maximum) / 2;
    uncut.within = (maximum - minimum) / 2 + chord_ * perimeter_;
    const UncutDepths depths{.radius = radius_, .farAway = perimeter_, .deepEnough = o_.tolerance};
    uncut.places = uncutPlaces(cells_, strips, fine_, ways_, depths, progress, progress.part(0.9, 1));
    return uncut;
  }

 private:
  static void frame(UncutCell& whole) {
    constexpr double far = std::numeric_limits<double>::infinity();
    whole.low = {far, far};
    whole.high = {-far, -far};
    for (const Rim& rim : whole.rims)
      for (const double y : {rim.low, rim.high}) {
        const Vec2 p(rim.curve.at(y), y);
        whole.low = whole.low.cwiseMin(p);
        whole.high = whole.high.cwiseMax(p);
      }
  }

  void findCovers(const Progress& progress) {
    const auto add = [&](const std::vector<Slab>& slabs) {
      if (covers_.size() % 64 == 0) progress.check();
      for (const Slab& slab : slabs)
        covers_.push_back({slab, std::min(slab.left.at(slab.low), slab.left.at(slab.high)),
                           std::max(slab.right.at(slab.low), slab.right.at(slab.high))});
    };
    for (const Stroke& way : ways_.strokes) add(sweptSlabs(way, radius_));
    for (const Vec2& end : ways_.ends) add(discSlabs(end, radius_));
  }

  void findFineness(const UncutCell& whole) {
    const double height = whole.high.y() - whole.low.y();
    const double size = height + std::abs(whole.low.y()) + std::abs(whole.high.y());
    fine_.thinnest = 1e-9 * height;
    fine_.slack = 1e-12 * size;
    fine_.same = 1e-13 * size;
    fine_.apart = std::max(radius_ / 4, height / 400);
  }

  UncutOptions o_;
  FloorWays ways_;
  double radius_ = 0, partArea_ = 0, perimeter_ = 0, chord_ = 0;
  UncutFineness fine_;
  std::vector<UncutCover> covers_;
  std::vector<UncutCell> cells_;
  std::size_t steps_ = 0;
};

}  // namespace

Uncut uncutOf(const Region& part, const Toolpath& path, const UncutOptions& options, const Progress& progress) {
  progress.report(0, "Measuring what stays uncut");
  UncutSearch search(part, path, options, progress);
  return search.search(progress);
}

}  // namespace blossom::pocket
