#include "kernel/convolution.h"

#include <algorithm>
#include <tuple>

#include "core/error.h"

namespace blossom::minkowski {
namespace {

constexpr std::size_t mostEdges = 3'000'000;

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

/// Strictly larger both ways: only then the other set has room inside without filling it.
bool hasRoom(const GridLoop& hole, const GridLoop& other) {
  const Extent h = extentOf(hole), o = extentOf(other);
  const GridPoint room = h.high - h.low, wanted = o.high - o.low;
  return room.x > wanted.x && room.y > wanted.y;
}

std::vector<const GridLoop*> loopsThatMatter(const GridPolygon& polygon, const GridPolygon& other) {
  std::vector<const GridLoop*> loops{&polygon.outer};
  for (const GridLoop& hole : polygon.holes)
    if (hasRoom(hole, other.outer)) loops.push_back(&hole);
  return loops;
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

/// Which end of a corner's range of directions belongs to it: with opposite ends for the two sets, parallel edges pair once.
enum class Closed { First, Last };

void addPairs(const std::vector<DirectedEdge>& edges, const std::vector<Corner>& corners, Closed closed,
              std::vector<CountedEdge>& out, const Progress& progress) {
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
      for (; first != last; ++first) out.push_back({first->from + corner.at, first->to + corner.at, corner.sign});
    };
    const auto first = rangeStart(corner.first), last = rangeStart(corner.last);
    if (before(corner.first, corner.last)) {
      pair(first, last);
    } else {  // past +x
      pair(first, edges.end());
      pair(edges.begin(), last);
    }
    if (out.size() > mostEdges)
      throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has more than three million edges.",
                  "Raise the tolerance, so that curves get fewer corners.");
  }
}

}  // namespace

void joinEqual(std::vector<CountedEdge>& edges) {
  for (CountedEdge& edge : edges)
    if (edge.to < edge.from) {
      std::swap(edge.from, edge.to);
      edge.count = -edge.count;
    }
  std::sort(edges.begin(), edges.end(),
            [](const CountedEdge& a, const CountedEdge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    CountedEdge sum = edges[i];
    for (++i; i < edges.size() && edges[i].from == sum.from && edges[i].to == sum.to; ++i) sum.count += edges[i].count;
    if (sum.count != 0) edges[kept++] = sum;
  }
  edges.resize(kept);
}

std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& progress) {
  struct Side {
    std::vector<DirectedEdge> edges;
    std::vector<Corner> corners;
  };
  const auto sidesOf = [](const std::vector<const GridLoop*>& loops) {
    std::vector<Side> sides;
    sides.reserve(loops.size());
    for (const GridLoop* loop : loops) sides.push_back({edgesByDirection(*loop), cornersOf(*loop)});
    return sides;
  };
  std::vector<CountedEdge> edges;
  for (const GridPolygon& partA : a)
    for (const GridPolygon& partB : b) {
      const std::vector<Side> sidesB = sidesOf(loopsThatMatter(partB, partA));
      for (const Side& sideA : sidesOf(loopsThatMatter(partA, partB)))
        for (const Side& sideB : sidesB) {
          addPairs(sideA.edges, sideB.corners, Closed::First, edges, progress);
          addPairs(sideB.edges, sideA.corners, Closed::Last, edges, progress);
        }
    }
  joinEqual(edges);
  return edges;
}

}  // namespace blossom::minkowski
