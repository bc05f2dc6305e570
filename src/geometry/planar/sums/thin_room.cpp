#include "geometry/planar/sums/thin_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/numeric/box_tree.h"
#include "geometry/numeric/union_find.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/thin_chain.h"

namespace blossom::planar {
namespace {

constexpr double weldedWithin = 8;  // times the slack: corners of what is narrow are less than four apart
constexpr double insideWithin = 2;  // times the slack: what lies so close to the room belongs to it
constexpr double shortest = 64;     // times the slack: acute corners of the wider room stick out of the other by less
constexpr double pointWithin = 32;  // times the slack: what is no longer is a point

using Link = std::pair<std::size_t, std::size_t>;  ///< numbers of knots, the smaller one first

/// How often an edge is passed either way.
struct Passes {
  int forward = 0, backward = 0;
};

/// The corners of loops, those that lie close together as one knot.
class Knots {
 public:
  Knots(const Polygons& polygons, double within, const Progress& progress) : within_(within) {
    for (const auto& [outer, holes] : polygons) {
      add(outer);
      for (const Loop& hole : holes) add(hole);
    }
    weld(progress);
  }

  [[nodiscard]] const std::vector<Vec2>& places() const { return places_; }
  /// Edges between knots, cut at the knots beside them; those that lead nowhere are left out.
  [[nodiscard]] std::map<Link, Passes> links(const Progress& progress) const {
    std::map<Link, Passes> all;
    for (const auto& [first, count] : loops_)
      for (std::size_t i = 0; i < count; ++i) {
        progress.check();
        const std::size_t from = knotOf_[first + i], to = knotOf_[first + (i + 1) % count];
        if (from == to) continue;
        const std::vector<std::size_t> passed = passedBetween(from, to);
        for (std::size_t k = 0; k + 1 < passed.size(); ++k) {
          const std::size_t a = passed[k], b = passed[k + 1];
          ++(a < b ? all[{a, b}].forward : all[{b, a}].backward);
        }
      }
    return all;
  }

 private:
  void add(const Loop& loop) {
    loops_.emplace_back(corners_.size(), loop.size());
    corners_.insert(corners_.end(), loop.begin(), loop.end());
  }

  void weld(const Progress& progress) {
    std::vector<Box2> boxes;
    for (const Vec2& p : corners_) boxes.emplace_back(p, p);
    UnionFind sets(corners_.size());
    if (!boxes.empty())
      forEachNearPair<2>(boxes, within_, progress, [&](std::size_t i, std::size_t j) {
        if ((corners_[i] - corners_[j]).norm() <= within_) sets.unite(i, j);
        return true;
      });
    std::map<std::size_t, std::size_t> numbers;
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto [place, isNew] = numbers.try_emplace(sets.find(i), places_.size());
      if (isNew) {
        places_.emplace_back(Vec2::Zero());
        sizes.push_back(0);
      }
      knotOf_.push_back(place->second);
      places_[place->second] += corners_[i];
      ++sizes[place->second];
    }
    for (std::size_t k = 0; k < places_.size(); ++k) places_[k] /= static_cast<double>(sizes[k]);
  }

  /// Both ends and the knots beside the line between them, in order.
  [[nodiscard]] std::vector<std::size_t> passedBetween(std::size_t from, std::size_t to) const {
    const Vec2 along = places_[to] - places_[from];
    std::vector<std::pair<double, std::size_t>> passed{{0, from}, {1, to}};
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (k == from || k == to) continue;
      const Vec2 off = places_[k] - places_[from];
      const double t = off.dot(along) / along.squaredNorm();
      if (t > 0 && t < 1 && std::abs(cross(along, off)) <= within_ * along.norm()) passed.emplace_back(t, k);
    }
    std::sort(passed.begin(), passed.end());
    std::vector<std::size_t> knots;
    for (const auto& [t, k] : passed) knots.push_back(k);
    return knots;
  }

  double within_;
  std::vector<Vec2> corners_, places_;
  std::vector<std::size_t> knotOf_;
  std::vector<std::pair<std::size_t, std::size_t>> loops_;  ///< first corner and number of corners
};

/// The room with its boundary as lines.
class RoomPlaces {
 public:
  RoomPlaces(const Region& room, double chord) : room_(room) {
    for (const Path& loop : room.loops) loops_.push_back(flatten(loop, chord));
  }

  [[nodiscard]] bool holds(const Vec2& p, double within) const {
    int winding = 0;
    for (const Path& loop : room_.loops) winding += windingNumber(loop, p);
    return winding > 0 || distance(p) <= within;
  }

  [[nodiscard]] double distance(const Vec2& p) const { return (nearest(p) - p).norm(); }

  /// On the boundary; infinitely far where there is no room.
  [[nodiscard]] Vec2 nearest(const Vec2& p) const {
    Vec2 best = Vec2::Constant(std::numeric_limits<double>::infinity());
    for (const std::vector<Vec2>& loop : loops_)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &from = loop[i], along = loop[(i + 1) % loop.size()] - from;
        const double t = std::clamp((p - from).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
        const Vec2 q = from + t * along;
        if (!((q - p).squaredNorm() >= (best - p).squaredNorm())) best = q;
      }
    return best;
  }

 private:
  const Region& room_;
  std::vector<std::vector<Vec2>> loops_;
};

/// Chains of knots, from one end or branching to the next, and rings.
std::vector<std::vector<std::size_t>> chainsOf(const std::vector<Link>& links, std::size_t knots) {
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> at(knots);  // neighbour and link
  for (std::size_t i = 0; i < links.size(); ++i) {
    at[links[i].first].emplace_back(links[i].second, i);
    at[links[i].second].emplace_back(links[i].first, i);
  }
  std::vector<bool> used(links.size(), false);
  std::vector<std::vector<std::size_t>> chains;
  const auto walk = [&](std::size_t start) {
    for (const auto& [next, link] : at[start]) {
      if (used[link]) continue;
      std::vector<std::size_t> chain{start};
      std::size_t knot = next;
      used[link] = true;
      chain.push_back(knot);
      while (at[knot].size() == 2 && knot != start) {
        const auto& [to, on] = used[at[knot][0].second] ? at[knot][1] : at[knot][0];
        if (used[on]) break;
        used[on] = true;
        knot = to;
        chain.push_back(knot);
      }
      chains.push_back(std::move(chain));
    }
  };
  for (std::size_t k = 0; k < knots; ++k)
    if (at[k].size() != 2) walk(k);
  for (std::size_t k = 0; k < knots; ++k) walk(k);
  return chains;
}

double lengthAlong(const std::vector<Vec2>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

class ThinFinder {
 public:
  ThinFinder(const Polygons& loose, const Region& room, const Widening& by, const Progress& progress)
      : slack_(by.slack),
        curved_(by.curved),
        progress_(progress),
        knots_(loose, weldedWithin * by.slack, progress),
        room_(room, by.slack) {}

  ThinRoom run() {
    std::vector<Link> both;
    std::vector<bool> linked(knots_.places().size(), false);
    for (const auto& [link, passes] : knots_.links(progress_)) {
      linked[link.first] = linked[link.second] = true;
      const Vec2 middle = (place(link.first) + place(link.second)) / 2;
      if (passes.forward > 0 && passes.backward > 0 && !room_.holds(middle, insideWithin * slack_)) both.push_back(link);
    }
    for (const std::vector<std::size_t>& chain : chainsOf(both, linked.size())) add(chain);
    for (std::size_t k = 0; k < linked.size(); ++k)
      if (!linked[k]) addPoint(place(k));
    return std::move(out_);
  }

 private:
  [[nodiscard]] Vec2 place(std::size_t knot) const { return knots_.places()[knot]; }

  void addPoint(const Vec2& p) {
    if (!room_.holds(p, shortest * slack_)) out_.points.push_back(p);
  }

  void add(const std::vector<std::size_t>& chain) {
    std::vector<Vec2> points;
    for (const std::size_t knot : chain) points.push_back(place(knot));
    bool atRoom = false;
    for (Vec2* end : {&points.front(), &points.back()}) {
      const Vec2 near = room_.nearest(*end);
      if (!((near - *end).norm() <= shortest * slack_)) continue;
      atRoom = true;
      *end = near;
    }
    const double length = lengthAlong(points);
    if (atRoom && length <= shortest * slack_) return;
    if (length <= pointWithin * slack_)
      addPoint((points.front() + points.back()) / 2);
    else
      out_.curves.push_back(fittedChain(points, chain.front() == chain.back(), {insideWithin * slack_, curved_}, progress_));
  }

  double slack_;
  bool curved_;
  const Progress& progress_;
  Knots knots_;
  RoomPlaces room_;
  ThinRoom out_;
};

}  // namespace

ThinRoom thinParts(const Polygons& loose, const Region& room, const Widening& by, const Progress& progress) {
  if (loose.empty()) return {};
  return ThinFinder(loose, room, by, progress).run();
}

}  // namespace blossom::planar
