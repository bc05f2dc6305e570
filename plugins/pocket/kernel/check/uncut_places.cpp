#include "kernel/check/uncut_places.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/numeric/union_find.h"
#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

namespace {

class PlaceSearch {
 public:
  PlaceSearch(const std::vector<UncutCell>& cells, const std::vector<std::vector<UncutStrip>>& strips,
              const UncutFineness& fine, const Progress& progress)
      : fine_(fine) {
    std::vector<std::pair<std::size_t, std::size_t>> touching;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      progress.check();
      addCell(cells[c], strips[c], touching);
    }
    progress.check();
    joinAcrossBorders(touching);
    same_ = UnionFind(gaps_.size());
    for (const auto& [a, b] : touching) same_.unite(a, b);
  }

  std::vector<UncutPlace> found(const FloorWays& ways, const UncutDepths& depths, const Progress& progress) {
    std::vector<Stroke> strokes = ways.strokes;
    for (const Vec2& end : ways.ends) strokes.push_back(Stroke::line(end, end));
    const StrokeTree swept(std::move(strokes));
    std::map<std::size_t, Growing> places;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (i % 1024 == 0) progress.report(static_cast<double>(i) / static_cast<double>(gaps_.size()));
      const Gap& gap = gaps_[i];
      Growing& growing = places[same_.find(i)];
      growing.place.area += gap.area;
      if (gap.isRow) growing.place.hatch.emplace_back(Vec2(gap.at.first, gap.y), Vec2(gap.at.second, gap.y));
      for (const double share : {0.5, 0.0, 1.0})
        probe(growing, i, Vec2(gap.at.first + share * (gap.at.second - gap.at.first), gap.y),
              [&](const Vec2& p) { return (swept.empty() ? depths.farAway : swept.nearest(p).distance) - depths.radius; });
    }
    std::vector<UncutPlace> out;
    for (auto& [root, growing] : places) {
      UncutPlace& place = growing.place;
      if (place.depth <= depths.deepEnough) continue;
      const Gap& widest = gaps_[growing.deepest];
      joinHatch(place.hatch);
      place.hatch.emplace_back(Vec2(widest.at.first, place.at.y()), Vec2(widest.at.second, place.at.y()));
      out.push_back(std::move(place));
    }
    std::stable_sort(out.begin(), out.end(), [](const UncutPlace& a, const UncutPlace& b) { return a.area > b.area; });
    return out;
  }

 private:
  struct Gap {
    double y = 0, low = 0, high = 0;  ///< the height of `at`, and its strip's ends
    std::pair<double, double> at, reach;
    double area = 0;
    bool isRow = false;  ///< to be drawn
  };
  /// Something at a border of cells.
  struct Beside {
    double low = 0, high = 0;
    std::size_t gap = 0;
    bool after = false;  ///< on which side
  };
  struct Growing {
    UncutPlace place;
    std::size_t deepest = 0;
    Vec2 probed = Vec2::Zero();  ///< where it was looked last ..
    double depth = 1e300;        ///< .. and what was found there
  };

  void addCell(const UncutCell& cell, const std::vector<UncutStrip>& strips,
               std::vector<std::pair<std::size_t, std::size_t>>& touching) {
    std::size_t before = gaps_.size();  // the first gap of the strip below
    for (std::size_t s = 0; s < strips.size(); ++s) {
      const std::size_t first = gaps_.size();
      addStrip(strips[s]);
      if (s > 0 && strips[s].low <= strips[s - 1].high + fine_.slack)
        for (std::size_t i = before; i < first; ++i)
          for (std::size_t k = first; k < gaps_.size(); ++k)
            if (gaps_[k].reach.first <= gaps_[i].reach.second && gaps_[i].reach.first <= gaps_[k].reach.second)
              touching.emplace_back(i, k);
      for (std::size_t i = first; i < gaps_.size(); ++i) addToBorders(cell, i);
      before = first;
    }
  }

  void addStrip(const UncutStrip& strip) {
    double width = 0;
    for (const auto& [left, right] : strip.area.gaps) width += right - left;
    const double mean = (strip.area.minimum + strip.area.maximum) / 2;
    for (const auto& gap : strip.area.gaps) {
      Gap each{strip.at,
               strip.low,
               strip.high,
               gap,
               gap,
               width > 0 ? mean * (gap.second - gap.first) / width : 0,
               fine_.isRow(strip.low)};
      for (const auto& reach : strip.area.reach)
        if (reach.first <= gap.second && gap.first <= reach.second) {
          each.reach.first = std::min(each.reach.first, reach.first);
          each.reach.second = std::max(each.reach.second, reach.second);
        }
      gaps_.push_back(each);
    }
  }

  void addToBorders(const UncutCell& cell, std::size_t i) {
    const Gap& gap = gaps_[i];
    const double slack = fine_.slack;
    if (gap.reach.first <= cell.low.x() + slack) upright_[cell.low.x()].push_back({gap.low, gap.high, i, true});
    if (gap.reach.second >= cell.high.x() - slack) upright_[cell.high.x()].push_back({gap.low, gap.high, i, false});
    const auto& [left, right] = gap.reach;
    if (gap.low <= cell.low.y() + slack) level_[cell.low.y()].push_back({left, right, i, true});
    if (gap.high >= cell.high.y() - slack) level_[cell.high.y()].push_back({left, right, i, false});
  }

  void joinAcrossBorders(std::vector<std::pair<std::size_t, std::size_t>>& touching) {
    for (auto* borders : {&upright_, &level_})
      for (auto& [at, beside] : *borders) {
        std::sort(beside.begin(), beside.end(), [](const Beside& a, const Beside& b) { return a.low < b.low; });
        std::vector<Beside> active;
        for (const Beside& each : beside) {
          std::erase_if(active, [&](const Beside& other) { return other.high <= each.low; });
          for (const Beside& other : active)
            if (other.after != each.after) touching.emplace_back(other.gap, each.gap);
          active.push_back(each);
        }
      }
  }

  /// The distance from the cut area has a Lipschitz constant of 1: near the last point it need not be computed.
  template <class Depth>
  static void probe(Growing& growing, std::size_t gap, const Vec2& p, const Depth& depthAt) {
    if (growing.depth + (p - growing.probed).norm() <= growing.place.depth) return;
    growing.probed = p;
    growing.depth = depthAt(p);
    if (growing.depth <= growing.place.depth) return;
    growing.place.depth = growing.depth;
    growing.place.at = p;
    growing.deepest = gap;
  }

  /// Rows go on from cell to cell.
  void joinHatch(std::vector<std::pair<Vec2, Vec2>>& hatch) const {
    std::sort(hatch.begin(), hatch.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first.y(), a.first.x()) < std::pair(b.first.y(), b.first.x());
    });
    std::vector<std::pair<Vec2, Vec2>> joined;
    for (const auto& row : hatch) {
      if (!joined.empty() && joined.back().first.y() == row.first.y() &&
          row.first.x() <= joined.back().second.x() + fine_.slack)
        joined.back().second = row.second;
      else
        joined.push_back(row);
    }
    hatch = std::move(joined);
  }

  const UncutFineness& fine_;
  std::vector<Gap> gaps_;
  std::map<double, std::vector<Beside>> upright_, level_;  ///< borders of cells, by their place
  UnionFind same_{0};
};

}  // namespace

std::vector<UncutPlace> uncutPlaces(const std::vector<UncutCell>& cells, const std::vector<std::vector<UncutStrip>>& strips,
                                    const UncutFineness& fine, const FloorWays& ways, const UncutDepths& depths,
                                    const Progress& joining, const Progress& measuring) {
  return PlaceSearch(cells, strips, fine, joining).found(ways, depths, measuring);
}

}  // namespace blossom::pocket
