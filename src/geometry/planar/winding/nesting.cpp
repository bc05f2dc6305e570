#include "geometry/planar/winding/nesting.h"

#include <algorithm>
#include <set>

#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/touching_loops.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {
namespace {

/// An edge from its left to its right end; upright ones are left out of the sweep.
struct SweptEdge {
  GridPoint left, right;
  std::size_t loop = 0;
  bool forward = true;  ///< its loop runs to the right here
};

/// The order in which edges lie over one another, where they lie over one another and do not cross.
struct Below {
  bool operator()(const SweptEdge* a, const SweptEdge* b) const {
    if (a == b) return false;
    const bool aFirst = a->left.x <= b->left.x;
    const SweptEdge &line = aFirst ? *a : *b, &other = aFirst ? *b : *a;
    const GridPoint along = line.right - line.left;
    Wide side = cross(along, other.left - line.left);
    if (side == 0) side = cross(along, other.right - line.left);
    return aFirst ? side > 0 : side < 0;
  }
};

int turnOf(const GridLoop& loop) {
  const auto lowest = static_cast<std::size_t>(std::min_element(loop.begin(), loop.end()) - loop.begin());
  const std::size_t n = loop.size();
  const GridPoint &before = loop[(lowest + n - 1) % n], &after = loop[(lowest + 1) % n];
  return cross(loop[lowest] - before, after - loop[lowest]) > 0 ? 1 : -1;
}

std::vector<SweptEdge> sweptEdges(const std::vector<GridLoop>& loops) {
  std::vector<SweptEdge> edges;
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t k = 0; k < loops[i].size(); ++k) {
      const GridPoint &from = loops[i][k], &to = loops[i][(k + 1) % loops[i].size()];
      if (from.x == to.x) continue;
      edges.push_back(from.x < to.x ? SweptEdge{from, to, i, true} : SweptEdge{to, from, i, false});
    }
  return edges;
}

template <class Key>
std::vector<std::size_t> sortedBy(std::size_t count, Key key) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// A sweep line from left to right over all edges. Where a loop begins, the edge below determines the loop that contains it.
class Sweep {
 public:
  explicit Sweep(const std::vector<GridLoop>& loops)
      : edges_(sweptEdges(loops)), places_(edges_.size()), firsts_(loops.size()), around_(loops.size()) {
    for (const GridLoop& loop : loops) {
      starts_.push_back(*std::min_element(loop.begin(), loop.end()));
      turns_.push_back(turnOf(loop));
    }
    entering_ = sortedBy(edges_.size(), [&](std::size_t i) { return edges_[i].left; });
    leaving_ = sortedBy(edges_.size(), [&](std::size_t i) { return edges_[i].right.x; });
  }

  std::vector<std::optional<std::size_t>> run(const Progress& progress) {
    for (const std::size_t loop : sortedBy(starts_.size(), [&](std::size_t i) { return starts_[i]; })) {
      moveTo(starts_[loop].x, progress);
      around_[loop] = loopBelow(*firsts_[loop]);
    }
    return around_;
  }

 private:
  using Place = std::set<const SweptEdge*, Below>::const_iterator;

  /// At one place what ends goes before what begins.
  void moveTo(std::int64_t x, const Progress& progress) {
    for (; entered_ < entering_.size() && edges_[entering_[entered_]].left.x <= x; ++entered_) {
      progress.check();
      const SweptEdge& edge = edges_[entering_[entered_]];
      removeUpTo(edge.left.x);
      const Place place = crossed_.insert(&edge).first;
      places_[entering_[entered_]] = place;
      std::optional<Place>& first = firsts_[edge.loop];
      if (edge.left == starts_[edge.loop] && (!first || Below()(&edge, **first))) first = place;
    }
    removeUpTo(x);
  }

  void removeUpTo(std::int64_t x) {
    for (; left_ < leaving_.size() && edges_[leaving_[left_]].right.x <= x; ++left_)
      crossed_.erase(places_[leaving_[left_]]);
  }

  [[nodiscard]] std::optional<std::size_t> loopBelow(Place place) const {
    if (place == crossed_.begin()) return std::nullopt;
    const SweptEdge& below = **std::prev(place);
    const bool opensUp = below.forward == (turns_[below.loop] > 0);
    return opensUp ? std::optional(below.loop) : around_[below.loop];
  }

  std::vector<SweptEdge> edges_;
  std::set<const SweptEdge*, Below> crossed_;
  std::vector<Place> places_;                 ///< of the edges that are crossed
  std::vector<std::optional<Place>> firsts_;  ///< of the loops' lower edges at their starts
  std::vector<std::optional<std::size_t>> around_;
  std::vector<GridPoint> starts_;  ///< leftmost points of the loops
  std::vector<int> turns_;
  std::vector<std::size_t> entering_, leaving_;
  std::size_t entered_ = 0, left_ = 0;
};

bool enclosesToItsLeft(const GridLoop& loop) {
  Wide twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return twice > 0;
}

/// A clockwise speck, of which rounding makes a box, leaves out nothing; any other loop keeps its direction.
GridLoop snappedLoop(const Loop& loop, const Grid& grid) {
  const std::vector<GridPolygon> image = snapped({{loop, {}}}, grid);
  if (image.empty() || (signedArea(loop) < 0 && enclosesToItsLeft(image.front().outer))) return {};
  return image.front().outer;
}

Grid gridOver(const std::vector<Loop>& loops) {
  Box2 box;
  for (const Loop& loop : loops)
    for (const Vec2& p : loop) box.extend(p);
  return {box.center(), gridUnit(box.sizes())};
}

}  // namespace

std::vector<std::optional<std::size_t>> loopsAround(const std::vector<GridLoop>& loops, const Progress& progress) {
  return Sweep(loops).run(progress);
}

Nesting::Nesting(std::vector<Loop> loops, const Progress& progress) : loops_(std::move(loops)), grid_(gridOver(loops_)) {
  std::vector<GridLoop> images;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    progress.check();
    GridLoop image = snappedLoop(loops_[i], grid_);
    if (image.empty()) continue;
    places_.push_back(i);
    turns_.push_back(turnOf(image));
    images.push_back(image);
    snapped_.push_back({std::move(image), {}});
  }
  clear_ = isClear(snapped_, progress);
  if (clear_) around_ = loopsAround(images, progress);
}

std::optional<std::size_t> Nesting::strayHole() const {
  for (std::size_t i = 0; i < around_.size(); ++i)
    if (turns_[i] < 0 && !around_[i]) return places_[i];
  return std::nullopt;
}

std::optional<std::vector<Nesting::Part>> Nesting::parts() const { return clear_ ? partsBy(around_) : std::nullopt; }

std::optional<std::vector<Nesting::Part>> Nesting::touchingParts(const Progress& progress) const {
  if (clear_) return parts();
  std::vector<GridLoop> images;
  for (const GridPolygon& loop : snapped_) images.push_back(loop.outer);
  const auto around = touchingLoopsAround(images, progress);
  return around ? partsBy(*around) : std::nullopt;
}

std::optional<std::vector<Nesting::Part>> Nesting::partsBy(const Around& around) const {
  for (std::size_t i = 0; i < around.size(); ++i)
    if (around[i] ? turns_[*around[i]] == turns_[i] : turns_[i] < 0) return std::nullopt;
  std::vector<Part> parts;
  std::vector<std::size_t> partOf(snapped_.size());
  for (std::size_t i = 0; i < snapped_.size(); ++i) {
    if (turns_[i] < 0) continue;
    partOf[i] = parts.size();
    parts.push_back({places_[i], {}});
  }
  for (std::size_t i = 0; i < snapped_.size(); ++i)
    if (turns_[i] < 0) parts[partOf[*around[i]]].holes.push_back(places_[i]);
  return parts;
}

Polygons Nesting::polygons(const Progress& progress) const {
  const auto sorted = parts();
  if (!sorted) return onPlane(windingFaces(edgesOf(snapped_), progress), grid_);
  Polygons result;
  for (const auto& [outer, holes] : *sorted) {
    Polygon& polygon = result.emplace_back(Polygon{loops_[outer], {}});
    for (const std::size_t hole : holes) polygon.holes.push_back(loops_[hole]);
  }
  return result;
}

}  // namespace blossom::planar
