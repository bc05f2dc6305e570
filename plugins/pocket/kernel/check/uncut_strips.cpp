#include "kernel/check/uncut_strips.h"

#include <algorithm>
#include <utility>

namespace blossom::pocket {

namespace {

using Rows = std::vector<const Slab*>;

/// The strips of a cell from below.
class CellStrips {
 public:
  CellStrips(const UncutCell& cell, const UncutFineness& fine, const Progress& progress)
      : cell_(cell), fine_(fine), progress_(progress), work_(fine.work), whole_(slabsOf(cell.rims)) {
    findLevels();
    const auto isLower = [](const Slab* a, const Slab* b) { return a->low < b->low; };
    Rows whole, covers;
    for (const Slab& slab : whole_) whole.push_back(&slab);
    for (const UncutCover* cover : cell.covers) covers.push_back(&cover->slab);
    std::sort(whole.begin(), whole.end(), isLower);
    std::sort(covers.begin(), covers.end(), isLower);
    Active parts{whole}, cuts{covers};
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      if (i % 64 == 0) progress_.check();
      const double middle = (levels_[i] + levels_[i + 1]) / 2;
      parts.goOnTo(middle);
      cuts.goOnTo(middle);
      if (!parts.now.empty()) measure(levels_[i], levels_[i + 1], parts.now, cuts.now);
    }
  }
  std::vector<UncutStrip> takeStrips() { return std::move(strips_); }
  [[nodiscard]] std::size_t steps() const { return steps_; }

 private:
  /// The slabs that span a height which only grows.
  struct Active {
    const Rows& waiting;  ///< the lowest first
    std::size_t next = 0;
    Rows now = {};

    void goOnTo(double y) {
      for (; next < waiting.size() && waiting[next]->low < y; ++next) now.push_back(waiting[next]);
      std::erase_if(now, [&](const Slab* slab) { return slab->high <= y; });
    }
  };

  /// Wherever a boundary begins, ends or turns, and the rows that are drawn.
  void findLevels() {
    double low = cell_.high.y(), high = cell_.low.y();
    for (const Slab& slab : whole_) {
      low = std::min(low, slab.low);
      high = std::max(high, slab.high);
      levels_.push_back(slab.low);
      levels_.push_back(slab.high);
    }
    for (const UncutCover* cover : cell_.covers)
      for (const double y : {cover->slab.low, cover->slab.high})
        if (low < y && y < high) levels_.push_back(y);
    for (double y = fine_.rowFrom(low); y < high; y += fine_.apart)
      if (y > low) levels_.push_back(fine_.rowFrom(y));
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end(), [&](double a, double b) { return b - a <= fine_.same; }),
                  levels_.end());
  }

  void measure(double low, double high, const Rows& whole, const Rows& covers) {
    const Vec2 side = cell_.high - cell_.low;
    const double apart = fine_.perBox * side.x() + fine_.perCell / side.y();  // mm2 in a mm of height
    // Thousands of gaps side by side would take too long: then the bounds remain farther apart, and `within` says so.
    int halvings = 8;
    std::vector<std::pair<double, double>> open{{low, high}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      steps_ += whole.size() + covers.size();
      StripArea area = stripArea(whole, covers, a, b, fine_.slack);
      if (area.maximum - area.minimum <= apart * (b - a) || b - a <= fine_.thinnest || !mayHalve(halvings, whole, covers)) {
        if (area.maximum > 0) add(a, b, std::move(area), whole, covers);
        continue;
      }
      if (++halved_ % 64 == 0) progress_.check();
      open.emplace_back((a + b) / 2, b);
      open.emplace_back(a, (a + b) / 2);
    }
  }

  /// A few times in every strip; then as long as the cell's work lasts, which few strips need.
  bool mayHalve(int& halvings, const Rows& whole, const Rows& covers) {
    if (halvings > 0) return halvings-- > 0;
    work_ -= static_cast<double>(whole.size() + covers.size());
    return work_ > 0;
  }

  void add(double low, double high, StripArea area, const Rows& whole, const Rows& covers) {
    double at = (low + high) / 2;
    if (fine_.isRow(low)) {
      at = fine_.rowFrom(low);
      area.gaps = gapsAt(whole, covers, at);
    }
    strips_.push_back({low, high, at, std::move(area)});
  }

  const UncutCell& cell_;
  const UncutFineness& fine_;
  const Progress& progress_;
  double work_;  ///< that is left
  std::size_t halved_ = 0, steps_ = 0;
  std::vector<UncutStrip> strips_;
  std::vector<Slab> whole_;
  std::vector<double> levels_;
};

}  // namespace

UncutStrips uncutStrips(const UncutCell& cell, const UncutFineness& fine, const Progress& progress) {
  CellStrips found(cell, fine, progress);
  return {found.takeStrips(), found.steps()};
}

}  // namespace blossom::pocket
