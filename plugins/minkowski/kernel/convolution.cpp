#include "kernel/convolution.h"

#include <algorithm>
#include <tuple>

#include "core/error.h"

namespace blossom::minkowski {
namespace {

constexpr std::size_t maximumEdges = 3'000'000;

struct Extent {
  GridPoint low, high;
};

Extent extentOf(const GridLoop& loop) {
  Extent box{loop.front(), loop.front()};
  for (const GridPoint& p : loop) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// A corner, turned so that its directions run counter-clockwise from `first` to `last`, by less than half a turn.
struct Corner {
  GridPoint at, first, last;
  int sign = 1;
};

std::vector<Corner> cornersOf(const GridLoop& loop) {
  std::vector<Corner> corners;
  corners.reserve(loop.size());
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint in = loop[i] - loop[(i + n - 1) % n], out = loop[(i + 1) % n] - loop[i];
    if (cross(in, out) > 0)
      corners.push_back({loop[i], in, out, 1});
    else
      corners.push_back({loop[i], out, in, -1});
  }
  return corners;
}

/// Directions by angle from +x, counter-clockwise, exactly.
bool before(const GridPoint& a, const GridPoint& b) {
  const auto upper = [](const GridPoint& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  return upper(a) != upper(b) ? upper(a) : cross(a, b) > 0;
}

struct DirectedEdge {
  GridPoint from, to;
  [[nodiscard]] GridPoint direction() const { return to - from; }
};

std::vector<DirectedEdge> edgesByDirection(const GridLoop& loop) {
  std::vector<DirectedEdge> edges;
  edges.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  std::sort(edges.begin(), edges.end(),
            [](const DirectedEdge& a, const DirectedEdge& b) { return before(a.direction(), b.direction()); });
  return edges;
}

/// Edges that are joined when they become too many: those of a lattice are few.
class EdgePile {
 public:
  EdgePile(const Effort& effort, const Progress& progress) : effort_(effort), progress_(progress) {}

  void add(const CountedEdge& edge) {
    edges_.push_back(edge);
    if (edges_.size() < full_) return;
    joinEqual(edges_, progress_);
    effort_.foresee(Effort::pairsOfEdge * static_cast<double>(edges_.size()));
    if (edges_.size() > maximumEdges)
      throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has more than three million edges.",
                  "Raise the tolerance, so that curves get fewer corners.");
    full_ = std::max(full_, 2 * edges_.size());
  }
  std::vector<CountedEdge> joined() && {
    joinEqual(edges_, progress_);
    effort_.foresee(Effort::pairsOfEdge * static_cast<double>(edges_.size()));
    return std::move(edges_);
  }

 private:
  const Effort& effort_;
  const Progress& progress_;
  std::vector<CountedEdge> edges_;
  std::size_t full_ = 100'000;
};

/// Which end of a corner's range of directions belongs to it: with opposite ends for the two sets, parallel edges pair once.
enum class Closed { First, Last };

void addPairs(const std::vector<DirectedEdge>& edges, const std::vector<Corner>& corners, Closed closed, EdgePile& out,
              const Progress& progress) {
  const auto rangeStart = [&](const GridPoint& direction) {
    return closed == Closed::First
               ? std::lower_bound(edges.begin(), edges.end(), direction,
                                  [](const DirectedEdge& e, const GridPoint& d) { return before(e.direction(), d); })
               : std::upper_bound(edges.begin(), edges.end(), direction,
                                  [](const GridPoint& d, const DirectedEdge& e) { return before(d, e.direction()); });
  };
  for (const Corner& corner : corners) {
    progress.check();
    const auto pair = [&](auto first, auto last) {
      for (; first != last; ++first) out.add({first->from + corner.at, first->to + corner.at, corner.sign, corner.sign > 0});
    };
    const auto first = rangeStart(corner.first), last = rangeStart(corner.last);
    if (before(corner.first, corner.last)) {
      pair(first, last);
    } else {  // past +x
      pair(first, edges.end());
      pair(edges.begin(), last);
    }
  }
}

/// A loop with all that pairing asks for.
struct LoopSides {
  std::vector<DirectedEdge> edges;
  std::vector<Corner> corners;
  GridPoint size;
};

LoopSides sidesOf(const GridLoop& loop) {
  const Extent extent = extentOf(loop);
  return {edgesByDirection(loop), cornersOf(loop), extent.high - extent.low};
}

struct PartSides {
  LoopSides outer;
  std::vector<LoopSides> holes;
};

std::vector<PartSides> partsOf(std::span<const GridPolygon> polygons, const Progress& progress) {
  std::vector<PartSides> parts;
  parts.reserve(polygons.size());
  for (const GridPolygon& polygon : polygons) {
    PartSides& part = parts.emplace_back(PartSides{sidesOf(polygon.outer), {}});
    for (const GridLoop& hole : polygon.holes) {
      progress.check();
      part.holes.push_back(sidesOf(hole));
    }
  }
  return parts;
}

/// Strictly larger both ways: only then the other set has room inside without filling it.
bool hasRoom(const LoopSides& hole, const LoopSides& other) {
  return hole.size.x > other.size.x && hole.size.y > other.size.y;
}

void pairUp(const LoopSides& a, const LoopSides& b, EdgePile& edges, const Progress& progress) {
  addPairs(a.edges, b.corners, Closed::First, edges, progress);
  addPairs(b.edges, a.corners, Closed::Last, edges, progress);
}

void pairUp(const PartSides& a, const PartSides& b, EdgePile& edges, const Progress& progress) {
  pairUp(a.outer, b.outer, edges, progress);
  for (const LoopSides& hole : b.holes)
    if (hasRoom(hole, a.outer)) pairUp(a.outer, hole, edges, progress);
  for (const LoopSides& hole : a.holes)
    if (hasRoom(hole, b.outer)) pairUp(hole, b.outer, edges, progress);
}

}  // namespace

void joinEqual(std::vector<CountedEdge>& edges, const Progress& progress) {
  for (CountedEdge& edge : edges)
    if (edge.to < edge.from) {
      std::swap(edge.from, edge.to);
      edge.count = -edge.count;
    }
  std::size_t compared = 0;
  std::sort(edges.begin(), edges.end(), [&](const CountedEdge& a, const CountedEdge& b) {
    if (++compared % 65536 == 0) progress.check();
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    CountedEdge sum = edges[i];
    for (++i; i < edges.size() && edges[i].from == sum.from && edges[i].to == sum.to; ++i) {
      sum.count += edges[i].count;
      sum.mayBound |= edges[i].mayBound;
    }
    if (sum.count != 0) edges[kept++] = sum;
  }
  edges.resize(kept);
}

std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& progress, const Effort& effort) {
  const std::vector<PartSides> partsA = partsOf(a, progress), partsB = partsOf(b, progress);
  EdgePile edges(effort, progress);
  for (std::size_t i = 0; i < partsA.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(partsA.size()), "Pairing edges");
    for (const PartSides& partB : partsB) pairUp(partsA[i], partB, edges, progress);
  }
  return std::move(edges).joined();
}

}  // namespace blossom::minkowski
