#include "kernel/uncut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

/// A strip whose area is bounded well enough.
struct Measured {
  double low = 0, high = 0;
  StripArea area;
};

class UncutSearch {
 public:
  UncutSearch(const Region& part, const Toolpath& path, const UncutOptions& options) : o_(options) {
    radius_ = path.cutter.diameter / 2;
    ways_ = floorWays(path, o_.floor);
    for (const Path& loop : part.loops) {
      partArea_ += signedArea(loop);
      perimeter_ += length(loop);
    }
    partArea_ = std::abs(partArea_);
    // Splines are taken as lines within this; the area of what lies between is at most chord times perimeter.
    chord_ = 1e-6 * partArea_ / perimeter_;
    std::vector<Rim> rims;
    for (const Path& loop : part.loops)
      for (const Stroke& stroke : strokesOf(loop, chord_)) addRims(stroke, rims);
    whole_ = slabsOf(rims);
    for (const Stroke& way : ways_.strokes)
      for (const Slab& slab : sweptSlabs(way, radius_)) covers_.push_back(slab);
    for (const Vec2& end : ways_.ends)
      for (const Slab& slab : discSlabs(end, radius_)) covers_.push_back(slab);
    findLevels();
  }

  Uncut search(const Progress& progress) const {
    std::vector<std::vector<Measured>> strips(levels_.size() - 1);
    constexpr std::size_t grain = 32;
    parallelFor(strips.size(), grain, progress.part(0, 0.9), [&](std::size_t begin, std::size_t end) {
      const auto whole = between(whole_, levels_[begin], levels_[end]),
                 covers = between(covers_, levels_[begin], levels_[end]);
      for (std::size_t i = begin; i < end; ++i) {
        progress.check();
        const double middle = (levels_[i] + levels_[i + 1]) / 2;
        measure(i, spanning(whole, middle), spanning(covers, middle), strips[i], progress);
      }
    });
    std::vector<Measured> all;
    for (std::vector<Measured>& some : strips) std::move(some.begin(), some.end(), std::back_inserter(all));
    Uncut uncut;
    uncut.partArea = partArea_;
    double least = 0, most = 0;
    for (const Measured& strip : all) {
      least += strip.area.least;
      most += strip.area.most;
    }
    uncut.area = (least + most) / 2;
    uncut.within = (most - least) / 2 + chord_ * perimeter_;
    findPlaces(all, uncut, progress.part(0.9, 1));
    return uncut;
  }

 private:
  void findLevels() {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Slab& slab : whole_) {
      low = std::min(low, slab.low);
      high = std::max(high, slab.high);
      levels_.push_back(slab.low);
      levels_.push_back(slab.high);
    }
    height_ = high - low;
    const auto isOutside = [&](const Slab& slab) { return slab.high <= low || slab.low >= high; };
    std::erase_if(covers_, isOutside);
    for (const Slab& slab : covers_)
      for (const double y : {slab.low, slab.high})
        if (low < y && y < high) levels_.push_back(y);
    std::sort(levels_.begin(), levels_.end());
    const double same = 1e-13 * (height_ + std::abs(low) + std::abs(high));
    levels_.erase(std::unique(levels_.begin(), levels_.end(), [&](double a, double b) { return b - a <= same; }),
                  levels_.end());
    slack_ = 1e-12 * (height_ + std::abs(low) + std::abs(high));
  }

  using Slabs = std::vector<const Slab*>;
  [[nodiscard]] static Slabs between(const std::vector<Slab>& slabs, double low, double high) {
    Slabs found;
    for (const Slab& slab : slabs)
      if (slab.low < high && low < slab.high) found.push_back(&slab);
    return found;
  }
  [[nodiscard]] static Slabs spanning(const Slabs& slabs, double middle) {
    Slabs found;
    for (const Slab* slab : slabs)
      if (slab->low < middle && middle < slab->high) found.push_back(slab);
    return found;
  }

  void measure(std::size_t i, const Slabs& whole, const Slabs& covers, std::vector<Measured>& out,
               const Progress& progress) const {
    if (whole.empty()) return;
    constexpr double share = 2e-6;  // of the part's area, that the bounds may be apart
    const double apart = share * partArea_ / height_;
    const double thinnest = 1e-9 * height_;
    // Thousands of gaps side by side would take ever so long: then the bounds stay further apart, and `within` tells.
    constexpr double mostWork = 1e7;  // covers looked at
    const double height = levels_[i + 1] - levels_[i];
    auto halvings = 8 + static_cast<std::size_t>(mostWork * height / height_ / static_cast<double>(covers.size() + 1));
    std::vector<std::pair<double, double>> open{{levels_[i], levels_[i + 1]}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      StripArea area = stripArea(whole, covers, a, b, slack_);
      if (area.most - area.least <= apart * (b - a) || b - a <= thinnest || halvings == 0) {
        if (area.most > 0) out.push_back({a, b, std::move(area)});
        continue;
      }
      if (--halvings % 64 == 0) progress.check();
      open.emplace_back((a + b) / 2, b);
      open.emplace_back(a, (a + b) / 2);
    }
  }

  /// Gaps of strips that follow one another and reach over the same x belong to one place.
  void findPlaces(const std::vector<Measured>& strips, Uncut& uncut, const Progress& progress) const {
    struct Gap {
      std::size_t strip = 0;
      std::pair<double, double> at, reach;
      double area = 0;
    };
    std::vector<Gap> gaps;
    std::vector<std::size_t> firstOf;
    for (std::size_t s = 0; s < strips.size(); ++s) {
      firstOf.push_back(gaps.size());
      double width = 0;
      for (const auto& [left, right] : strips[s].area.gaps) width += right - left;
      const double mean = (strips[s].area.least + strips[s].area.most) / 2;
      for (const auto& gap : strips[s].area.gaps) {
        Gap each{s, gap, gap, width > 0 ? mean * (gap.second - gap.first) / width : 0};
        for (const auto& reach : strips[s].area.reach)
          if (reach.first <= gap.second && gap.first <= reach.second) {
            each.reach.first = std::min(each.reach.first, reach.first);
            each.reach.second = std::max(each.reach.second, reach.second);
          }
        gaps.push_back(each);
      }
    }
    firstOf.push_back(gaps.size());
    UnionFind same(gaps.size());
    for (std::size_t s = 0; s + 1 < strips.size(); ++s) {
      if (strips[s + 1].low > strips[s].high + slack_) continue;
      for (std::size_t i = firstOf[s]; i < firstOf[s + 1]; ++i)
        for (std::size_t k = firstOf[s + 1]; k < firstOf[s + 2]; ++k)
          if (gaps[k].reach.first <= gaps[i].reach.second && gaps[i].reach.first <= gaps[k].reach.second) same.unite(i, k);
    }
    std::vector<Stroke> strokes = ways_.strokes;
    for (const Vec2& end : ways_.ends) strokes.push_back(Stroke::line(end, end));
    const StrokeTree swept(std::move(strokes));
    const double apart = std::max(radius_ / 4, height_ / 400);  // of the rows that are drawn
    std::map<std::size_t, UncutPlace> places;
    std::map<std::size_t, std::size_t> deepest;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (i % 1024 == 0) progress.check();
      const Gap& gap = gaps[i];
      const Measured& strip = strips[gap.strip];
      const std::size_t root = same.find(i);
      UncutPlace& place = places[root];
      place.area += gap.area;
      const double y = (strip.low + strip.high) / 2;
      for (const double share : {0.5, 0.0, 1.0}) {
        const Vec2 p(gap.at.first + share * (gap.at.second - gap.at.first), y);
        const double depth = (swept.empty() ? perimeter_ : swept.nearest(p).distance) - radius_;
        if (depth <= place.depth) continue;
        place.depth = depth;
        place.at = p;
        deepest[root] = i;
      }
      if (std::floor(strip.low / apart) != std::floor(strip.high / apart))
        place.hatch.emplace_back(Vec2(gap.at.first, y), Vec2(gap.at.second, y));
    }
    for (auto& [root, place] : places) {
      if (place.depth <= o_.tolerance) continue;
      const Gap& widest = gaps[deepest.at(root)];
      place.hatch.emplace_back(Vec2(widest.at.first, place.at.y()), Vec2(widest.at.second, place.at.y()));
      uncut.places.push_back(std::move(place));
    }
    std::stable_sort(uncut.places.begin(), uncut.places.end(),
                     [](const UncutPlace& a, const UncutPlace& b) { return a.area > b.area; });
  }

  UncutOptions o_;
  double radius_ = 0, partArea_ = 0, perimeter_ = 0, chord_ = 0, height_ = 0, slack_ = 0;
  FloorWays ways_;
  std::vector<Slab> whole_, covers_;
  std::vector<double> levels_;
};

}  // namespace

Uncut uncutOf(const Region& part, const Toolpath& path, const UncutOptions& options, const Progress& progress) {
  progress.report(0, "Measuring what stays uncut");
  return UncutSearch(part, path, options).search(progress);
}

}  // namespace blossom::pocket
