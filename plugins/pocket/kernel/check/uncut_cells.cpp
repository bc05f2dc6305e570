#include "kernel/check/uncut_cells.h"

#include <algorithm>
#include <utility>

namespace blossom::pocket {

namespace {

/// Curves are monotone in x, so the ends bound them.
bool hides(const UncutCover& cover, const UncutCell& cell) {
  const Slab& slab = cover.slab;
  if (slab.low > cell.low.y() || slab.high < cell.high.y()) return false;
  return std::max(slab.left.at(cell.low.y()), slab.left.at(cell.high.y())) <= cell.low.x() &&
         std::min(slab.right.at(cell.low.y()), slab.right.at(cell.high.y())) >= cell.high.x();
}

class CellSearch {
 public:
  CellSearch(UncutCell whole, const Progress& progress) {
    std::vector<UncutCell> open;
    open.push_back(std::move(whole));
    while (!open.empty()) {
      progress.check();
      UncutCell cell = std::move(open.back());
      open.pop_back();
      steps_ += cell.size();
      if (cell.rims.empty()) continue;
      if (!isSmall(cell) && halve(cell, open)) continue;
      cells_.push_back(std::move(cell));
    }
  }
  std::vector<UncutCell> takeCells() { return std::move(cells_); }
  [[nodiscard]] std::size_t steps() const { return steps_; }

 private:
  static bool isSmall(const UncutCell& cell) {
    constexpr std::size_t few = 48;
    constexpr int deepest = 48;
    return cell.size() <= few || cell.depth >= deepest;
  }

  /// Across its longer side, else along it; not when nearly everything would be in both halves.
  static bool halve(UncutCell& cell, std::vector<UncutCell>& open) {
    const Vec2 side = cell.high - cell.low;
    const int longer = side.x() > side.y() ? 0 : 1;
    for (const int axis : {longer, 1 - longer}) {
      std::vector<UncutCell> halves = halvesOf(cell, axis);
      std::size_t sum = 0;
      for (const UncutCell& half : halves) sum += half.size();
      if (4 * sum > 7 * cell.size()) continue;
      cell = {};
      for (UncutCell& half : halves) open.push_back(std::move(half));
      return true;
    }
    return false;
  }

  /// Without those that a sweep hides.
  static std::vector<UncutCell> halvesOf(const UncutCell& cell, int axis) {
    const double middle = (cell.low[axis] + cell.high[axis]) / 2;
    SplitRims rims = axis == 0 ? splitAtLine(cell.rims, middle) : splitAtHeight(cell.rims, middle);
    UncutCell before{cell.low, cell.high, std::move(rims.before), {}, cell.depth + 1},
        after{cell.low, cell.high, std::move(rims.after), {}, cell.depth + 1};
    before.high[axis] = after.low[axis] = middle;
    std::vector<UncutCell> halves;
    for (UncutCell* half : {&before, &after}) {
      bool hidden = half->rims.empty();
      for (const UncutCover* cover : cell.covers) {
        if (!reaches(*cover, *half)) continue;
        half->covers.push_back(cover);
        hidden = hidden || hides(*cover, *half);
      }
      if (!hidden) halves.push_back(std::move(*half));
    }
    return halves;
  }

  std::vector<UncutCell> cells_;
  std::size_t steps_ = 0;
};

}  // namespace

bool reaches(const UncutCover& cover, const UncutCell& cell) {
  return cover.slab.low < cell.high.y() && cell.low.y() < cover.slab.high && cover.left < cell.high.x() &&
         cell.low.x() < cover.right;
}

UncutCells uncutCells(UncutCell whole, const Progress& progress) {
  CellSearch search(std::move(whole), progress);
  return {search.takeCells(), search.steps()};
}

}  // namespace blossom::pocket
