#include "kernel/uncut.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/parallel.h"
#include "geometry/planar.h"
#include "geometry/union_find.h"
#include "kernel/strip_area.h"
#include "kernel/stroke_tree.h"
#include "kernel/tool_moves.h"

namespace blossom::pocket {

namespace {

/// Where the tool's centre goes at the floor.
struct FloorWays {
  std::vector<Stroke> strokes;
  std::vector<Vec2> ends;  ///< where a disc is to be added: between ways that do not go straight on
};

bool goesOnStraight(const Stroke& a, const Stroke& b) {
  constexpr double straight = 1e-7;
  return a.to == b.from && std::abs(cross(a.direction(1), b.direction(0))) < straight &&
         a.direction(1).dot(b.direction(0)) > 0;
}

FloorWays floorWays(const Toolpath& path, double floor) {
  constexpr double sameHeight = 1e-3;
  FloorWays ways;
  bool cutting = false;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    const ToolMove& move = path.moves[i];
    const bool arrives = move.kind != MoveKind::Rapid && move.to.z() <= floor + sameHeight;
    if (!arrives || from.z() > floor + sameHeight) {
      if (arrives) ways.ends.emplace_back(move.to.head<2>());
      cutting = false;
      continue;
    }
    const Stroke way = wayOf(from, move);
    if (way.length() > 0) {
      if (!cutting || ways.strokes.empty() || !goesOnStraight(ways.strokes.back(), way)) ways.ends.push_back(way.from);
      ways.strokes.push_back(way);
    }
    ways.ends.emplace_back(move.to.head<2>());
    cutting = true;
    // The disc at the end is hidden when the next way goes straight on.
    if (i + 1 < path.moves.size() && path.moves[i + 1].kind != MoveKind::Rapid && way.length() > 0 &&
        path.moves[i + 1].to.z() <= floor + sameHeight && goesOnStraight(way, wayOf(move.to, path.moves[i + 1])))
      ways.ends.pop_back();
  }
  std::sort(ways.ends.begin(), ways.ends.end(),
            [](const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  ways.ends.erase(std::unique(ways.ends.begin(), ways.ends.end()), ways.ends.end());
  return ways;
}

/// A piece of what the tool sweeps.
struct Cover {
  Slab slab;
  double left = 0, right = 0;  ///< as far as it reaches anywhere
};

using Rows = std::vector<const Slab*>;

/// An upright box, and what of the part and of the sweeps lies in it.
struct Cell {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  std::vector<Rim> rims;
  std::vector<const Cover*> covers;
  int depth = 0;  ///< how often it was halved

  [[nodiscard]] std::size_t size() const { return rims.size() + covers.size(); }
  [[nodiscard]] double area() const { return (high - low).prod(); }
};

/// Curves do not change their direction in x, so the ends tell.
bool hides(const Cover& cover, const Cell& cell) {
  const Slab& slab = cover.slab;
  if (slab.low > cell.low.y() || slab.high < cell.high.y()) return false;
  return std::max(slab.left.at(cell.low.y()), slab.left.at(cell.high.y())) <= cell.low.x() &&
         std::min(slab.right.at(cell.low.y()), slab.right.at(cell.high.y())) >= cell.high.x();
}

bool reaches(const Cover& cover, const Cell& cell) {
  return cover.slab.low < cell.high.y() && cell.low.y() < cover.slab.high && cover.left < cell.high.x() &&
         cell.low.x() < cover.right;
}

/// Cells of a few curves each, which together hold all of the part that no single sweep hides.
class UncutCells {
 public:
  UncutCells(Cell whole, const Progress& progress) {
    std::vector<Cell> open;
    open.push_back(std::move(whole));
    while (!open.empty()) {
      progress.check();
      Cell cell = std::move(open.back());
      open.pop_back();
      steps_ += cell.size();
      if (cell.rims.empty()) continue;
      if (!isSmall(cell) && halve(cell, open)) continue;
      cells_.push_back(std::move(cell));
    }
  }
  std::vector<Cell> takeCells() { return std::move(cells_); }
  [[nodiscard]] std::size_t steps() const { return steps_; }

 private:
  static bool isSmall(const Cell& cell) {
    constexpr std::size_t few = 48;
    constexpr int deepest = 48;
    return cell.size() <= few || cell.depth >= deepest;
  }

  /// Across its longer side, else along it; not when nearly everything would be in both halves.
  static bool halve(Cell& cell, std::vector<Cell>& open) {
    const Vec2 side = cell.high - cell.low;
    const int longer = side.x() > side.y() ? 0 : 1;
    for (const int axis : {longer, 1 - longer}) {
      std::vector<Cell> halves = halvesOf(cell, axis);
      std::size_t sum = 0;
      for (const Cell& half : halves) sum += half.size();
      if (4 * sum > 7 * cell.size()) continue;
      cell = {};
      for (Cell& half : halves) open.push_back(std::move(half));
      return true;
    }
    return false;
  }

  /// Without those that a sweep hides.
  static std::vector<Cell> halvesOf(const Cell& cell, int axis) {
    const double middle = (cell.low[axis] + cell.high[axis]) / 2;
    SplitRims rims = axis == 0 ? splitAtLine(cell.rims, middle) : splitAtHeight(cell.rims, middle);
    Cell before{cell.low, cell.high, std::move(rims.before), {}, cell.depth + 1},
        after{cell.low, cell.high, std::move(rims.after), {}, cell.depth + 1};
    before.high[axis] = after.low[axis] = middle;
    std::vector<Cell> halves;
    for (Cell* half : {&before, &after}) {
      bool hidden = half->rims.empty();
      for (const Cover* cover : cell.covers) {
        if (!reaches(*cover, *half)) continue;
        half->covers.push_back(cover);
        hidden = hidden || hides(*cover, *half);
      }
      if (!hidden) halves.push_back(std::move(*half));
    }
    return halves;
  }

  std::vector<Cell> cells_;
  std::size_t steps_ = 0;
};

/// A strip whose area is bounded well enough.
struct Measured {
  double low = 0, high = 0;
  double at = 0;  ///< the height of its gaps
  StripArea area;
};

/// How finely strips are measured.
struct Fineness {
  double perBox = 0, perCell = 0;  ///< mm2 that bounds may be apart: in a mm2 of box, and besides in every cell
  double work = 0;                 ///< slabs that a cell may look at, above what every strip may
  double thinnest = 0;             ///< mm: lower strips are not halved
  double slack = 0;                ///< what rounding may do to x
  double same = 0;                 ///< heights closer to one another are one
  double apart = 0;                ///< of the rows that are drawn
  /// The first row not below a height, and whether one is there.
  [[nodiscard]] double rowFrom(double y) const { return apart * std::ceil((y - slack) / apart); }
  [[nodiscard]] bool isRow(double y) const { return rowFrom(y) - y <= slack; }
};

/// The strips of a cell from below.
class CellStrips {
 public:
  CellStrips(const Cell& cell, const Fineness& fine, const Progress& progress)
      : cell_(cell), fine_(fine), progress_(progress), work_(fine.work), whole_(slabsOf(cell.rims)) {
    findLevels();
    const auto isLower = [](const Slab* a, const Slab* b) { return a->low < b->low; };
    Rows whole, covers;
    for (const Slab& slab : whole_) whole.push_back(&slab);
    for (const Cover* cover : cell.covers) covers.push_back(&cover->slab);
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
  std::vector<Measured> takeStrips() { return std::move(strips_); }
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
    for (const Cover* cover : cell_.covers)
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
    // Thousands of gaps side by side would take ever so long: then the bounds stay further apart, and `within` tells.
    int halvings = 8;
    std::vector<std::pair<double, double>> open{{low, high}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      steps_ += whole.size() + covers.size();
      StripArea area = stripArea(whole, covers, a, b, fine_.slack);
      if (area.most - area.least <= apart * (b - a) || b - a <= fine_.thinnest || !mayHalve(halvings, whole, covers)) {
        if (area.most > 0) add(a, b, std::move(area), whole, covers);
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

  const Cell& cell_;
  const Fineness& fine_;
  const Progress& progress_;
  double work_;  ///< that is left
  std::size_t halved_ = 0, steps_ = 0;
  std::vector<Measured> strips_;
  std::vector<Slab> whole_;
  std::vector<double> levels_;
};

/// Joins what cells leave uncut into places.
class UncutPlaces {
 public:
  UncutPlaces(const std::vector<Cell>& cells, const std::vector<std::vector<Measured>>& strips, const Fineness& fine,
              const Progress& progress)
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

  /// @param deepEnough mm from what is cut, that a place must reach
  std::vector<UncutPlace> found(const FloorWays& ways, double radius, double farAway, double deepEnough,
                                const Progress& progress) {
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
              [&](const Vec2& p) { return (swept.empty() ? farAway : swept.nearest(p).distance) - radius; });
    }
    std::vector<UncutPlace> out;
    for (auto& [root, growing] : places) {
      UncutPlace& place = growing.place;
      if (place.depth <= deepEnough) continue;
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

  void addCell(const Cell& cell, const std::vector<Measured>& strips,
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

  void addStrip(const Measured& strip) {
    double width = 0;
    for (const auto& [left, right] : strip.area.gaps) width += right - left;
    const double mean = (strip.area.least + strip.area.most) / 2;
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

  void addToBorders(const Cell& cell, std::size_t i) {
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

  /// The distance from what is cut changes no faster than the place: near the last one it need not be asked for.
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

  const Fineness& fine_;
  std::vector<Gap> gaps_;
  std::map<double, std::vector<Beside>> upright_, level_;  ///< borders of cells, by their place
  UnionFind same_{0};
};

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
    Cell whole;
    for (const Path& loop : part.loops) {
      progress.check();
      for (const Stroke& stroke : strokesOf(loop, chord_)) addRims(stroke, whole.rims);
    }
    frame(whole);
    findCovers(progress);
    for (const Cover& cover : covers_)
      if (reaches(cover, whole)) whole.covers.push_back(&cover);
    findFineness(whole);
    UncutCells parted(std::move(whole), progress.part(0, 0.1));
    cells_ = parted.takeCells();
    steps_ = parted.steps();
  }

  Uncut search(const Progress& progress) {
    double boxes = 0;
    for (const Cell& cell : cells_) boxes += cell.area();
    constexpr double share = 2e-6;  // of the part's area, that the bounds may be apart
    const auto count = static_cast<double>(cells_.size());
    fine_.perBox = share / 2 * partArea_ / boxes;
    fine_.perCell = share / 2 * partArea_ / count;
    constexpr double mostWork = 5e8, mostWorkOfCell = 1e5;  // slabs looked at
    fine_.work = std::min(mostWorkOfCell, mostWork / count);
    std::vector<std::vector<Measured>> strips(cells_.size());
    std::vector<std::size_t> steps(cells_.size());
    std::atomic<std::size_t> done = 0;
    parallelFor(cells_.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        progress.report(0.9 * static_cast<double>(done++) / static_cast<double>(cells_.size()));
        CellStrips found(cells_[i], fine_, progress);
        strips[i] = std::move(found.takeStrips());
        steps[i] = found.steps();
      }
    });
    Uncut uncut;
    uncut.partArea = partArea_;
    uncut.steps = std::accumulate(steps.begin(), steps.end(), steps_);
    double least = 0, most = 0;
    for (const auto& some : strips)
      for (const Measured& strip : some) {
        least += strip.area.least;
        most += strip.area.most;
      }
    uncut.area = (least + most) / 2;
    uncut.within = (most - least) / 2 + chord_ * perimeter_;
    uncut.places =
        UncutPlaces(cells_, strips, fine_, progress).found(ways_, radius_, perimeter_, o_.tolerance, progress.part(0.9, 1));
    return uncut;
  }

 private:
  static void frame(Cell& whole) {
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

  void findFineness(const Cell& whole) {
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
  Fineness fine_;
  std::vector<Cover> covers_;
  std::vector<Cell> cells_;
  std::size_t steps_ = 0;
};

}  // namespace

Uncut uncutOf(const Region& part, const Toolpath& path, const UncutOptions& options, const Progress& progress) {
  progress.report(0, "Measuring what stays uncut");
  UncutSearch search(part, path, options, progress);
  return search.search(progress);
}

}  // namespace blossom::pocket
