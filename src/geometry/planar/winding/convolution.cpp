#include "geometry/planar/winding/convolution.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <tuple>

#include "core/error.h"
#include "core/parallel_sort.h"
#include "geometry/planar/winding/direction_order.h"
#include "geometry/planar/winding/left_out_edges.h"

namespace blossom::planar {
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
  GridPoint at;
  Direction first, last;
  int sign = 1;
  std::uint32_t number = CornerNumbers::unknown;
};

/// A loop and how its corners and edges are numbered.
struct NumberedLoop {
  const GridLoop& loop;
  const CornerNumbers* numbers = nullptr;  ///< none when nobody asks what edges come from
  std::span<const std::uint32_t> cornerNumbers{}, sideNumbers{};

  [[nodiscard]] std::uint32_t ofCorner(std::size_t i) const {
    if (!numbers) return CornerNumbers::unknown;
    return cornerNumbers.empty() ? numbers->of(loop[i], loop[(i + 1) % loop.size()]) : cornerNumbers[i];
  }
  [[nodiscard]] std::uint32_t ofEdge(std::size_t i) const {
    if (!numbers) return CornerNumbers::unknown;
    return sideNumbers.empty() ? numbers->ofEdge(loop[i], loop[(i + 1) % loop.size()]) : sideNumbers[i];
  }
};

std::vector<Corner> cornersOf(const NumberedLoop& numbered) {
  const GridLoop& loop = numbered.loop;
  std::vector<Corner> corners;
  corners.reserve(loop.size());
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint in = loop[i] - loop[(i + n - 1) % n], out = loop[(i + 1) % n] - loop[i];
    const Wide turn = cross(in, out);
    // A turn by half a turn is the end of a curve, one of no direction a point.
    if (turn > 0 || (turn == 0 && dot(in, out) <= 0))
      corners.push_back({loop[i], Direction(in), Direction(out), 1, numbered.ofCorner(i)});
    else
      corners.push_back({loop[i], Direction(out), Direction(in), -1});
  }
  return corners;
}

struct DirectedEdge {
  GridPoint from, to;
  std::uint32_t number = CornerNumbers::unknown;
  Direction direction = Direction(to - from);
};

std::vector<DirectedEdge> edgesByDirection(const NumberedLoop& numbered) {
  const GridLoop& loop = numbered.loop;
  std::vector<DirectedEdge> edges;
  if (loop.size() == 1) return edges;
  edges.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()], numbered.ofEdge(i)});
  std::sort(edges.begin(), edges.end(),
            [](const DirectedEdge& a, const DirectedEdge& b) { return before(a.direction, b.direction); });
  return edges;
}

/// Edges that are joined when they become too many: those of a lattice are few.
class EdgePile {
 public:
  /// @param inside edges in there are left out; or null
  EdgePile(const Effort& effort, const CertainInside* inside, const Progress& progress)
      : effort_(effort), progress_(progress) {
    if (inside) leftOut_.emplace(*inside);
  }

  /// An edge of the first or the second set moved by a corner of the other.
  void add(const DirectedEdge& edge, const Corner& corner, bool edgeOfFirst) {
    CountedEdge moved{edge.from + corner.at, edge.to + corner.at, corner.sign, corner.sign > 0};
    if (leftOut_ && leftOut_->take(moved)) return;
    if (corner.sign > 0 && edge.number != CornerNumbers::unknown && corner.number != CornerNumbers::unknown) {
      moved.source = static_cast<std::uint32_t>(sources_.size());
      sources_.push_back({edge.number, corner.number, edgeOfFirst});
    }
    edges_.push_back(moved);
    joinIfMany();
  }

  /// All of another pile.
  void add(EdgePile&& other) {
    const auto first = static_cast<std::uint32_t>(sources_.size() - 1);
    for (CountedEdge& edge : other.edges_)
      if (edge.source != 0) edge.source += first;
    sources_.insert(sources_.end(), other.sources_.begin() + 1, other.sources_.end());
    edges_.insert(edges_.end(), other.edges_.begin(), other.edges_.end());
    if (leftOut_) leftOut_->add(*std::move(other.leftOut_));
    joinIfMany();
  }

  /// @param sources when given, gets what the edges come from
  std::vector<CountedEdge> joined(PairSources* sources) && {
    if (leftOut_) {
      const std::vector<CountedEdge> closings = leftOut_->closings();
      edges_.insert(edges_.end(), closings.begin(), closings.end());
    }
    joinEqual(edges_, progress_);
    effort_.foresee(Effort::pairsOfEdge * static_cast<double>(edges_.size()));
    if (sources) sources->all = std::move(sources_);
    return std::move(edges_);
  }

 private:
  void joinIfMany() {
    if (edges_.size() < full_) return;
    joinEqual(edges_, progress_);
    effort_.foresee(Effort::pairsOfEdge * static_cast<double>(edges_.size()));
    if (edges_.size() > maximumEdges)
      throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has more than three million edges.",
                  "Simplify the outlines; of curves, raise the tolerance so that they get fewer corners.");
    full_ = std::max(full_, 2 * edges_.size());
  }

  const Effort& effort_;
  const Progress& progress_;
  std::optional<LeftOutEdges> leftOut_;
  std::vector<PairSources::Pair> sources_ = {PairSources::Pair()};  // the first one stands for unknown
  std::vector<CountedEdge> edges_;
  std::size_t full_ = 100'000;
};

/// Which end of a corner's range of directions belongs to it: with opposite ends for the two sets, parallel edges pair once.
/// First: the edges are those of the first set.
enum class Closed { First, Last };

/// Calls pair(first, last) for ranges of edges that a corner is paired with.
template <class Pair>
void forEachRange(const std::vector<DirectedEdge>& edges, const Corner& corner, Closed closed, Pair pair) {
  if (corner.first.along == corner.last.along) return pair(edges.begin(), edges.end());  // a point
  const auto rangeStart = [&](const Direction& direction) {
    return closed == Closed::First
               ? std::lower_bound(edges.begin(), edges.end(), direction,
                                  [](const DirectedEdge& e, const Direction& d) { return before(e.direction, d); })
               : std::upper_bound(edges.begin(), edges.end(), direction,
                                  [](const Direction& d, const DirectedEdge& e) { return before(d, e.direction); });
  };
  const auto first = rangeStart(corner.first), last = rangeStart(corner.last);
  if (before(corner.first, corner.last)) return pair(first, last);
  pair(first, edges.end());  // past +x
  pair(edges.begin(), last);
}

template <class Out>
void addPairs(const std::vector<DirectedEdge>& edges, std::span<const Corner> corners, Closed closed, Out& out,
              const Progress& progress) {
  for (const Corner& corner : corners) {
    progress.check();
    forEachRange(edges, corner, closed, [&](auto first, auto last) {
      for (; first != last; ++first) out.add(*first, corner, closed == Closed::First);
    });
  }
}

/// Pairs as they are.
struct PairList {
  std::vector<EdgeAtCorner> all;
  void add(const DirectedEdge& edge, const Corner& corner, bool edgeOfFirst) {
    all.push_back({edge.from, edge.to, corner.at, edgeOfFirst, corner.sign});
  }
};

/// How many there are.
struct PairTally {
  double count = 0;
};

void addPairs(const std::vector<DirectedEdge>& edges, std::span<const Corner> corners, Closed closed, PairTally& tally,
              const Progress& progress) {
  for (const Corner& corner : corners) {
    progress.check();
    forEachRange(edges, corner, closed,
                 [&](auto first, auto last) { tally.count += static_cast<double>(std::distance(first, last)); });
  }
}

/// Corners of one loop that are to be paired with the edges of another.
struct Pairing {
  const std::vector<DirectedEdge>* edges;
  std::span<const Corner> corners;
  Closed closed;
};

/// Of two sets, cut into pieces of so many corners.
struct PairingList {
  static constexpr std::size_t most = 256;
  std::vector<Pairing> all;
};

void addPairs(const std::vector<DirectedEdge>& edges, std::span<const Corner> corners, Closed closed, PairingList& list,
              const Progress&) {
  for (std::size_t i = 0; i < corners.size(); i += PairingList::most)
    list.all.push_back({&edges, corners.subspan(i, std::min(PairingList::most, corners.size() - i)), closed});
}

/// A loop with all that pairing asks for.
struct LoopSides {
  std::vector<DirectedEdge> edges;
  std::vector<Corner> corners;
  GridPoint size;
};

LoopSides sidesOf(const NumberedLoop& loop) {
  const Extent extent = extentOf(loop.loop);
  return {edgesByDirection(loop), cornersOf(loop), extent.high - extent.low};
}

struct PartSides {
  LoopSides outer;
  std::vector<LoopSides> holes;
};

std::vector<PartSides> partsOf(std::span<const GridPolygon> polygons, const CornerNumbers* numbers,
                               const Progress& progress) {
  std::vector<PartSides> parts;
  parts.reserve(polygons.size());
  for (const GridPolygon& polygon : polygons) {
    const NumberedLoop outer{polygon.outer, numbers, polygon.cornerNumbers, polygon.sideNumbers};
    PartSides& part = parts.emplace_back(PartSides{sidesOf(outer), {}});
    for (const GridLoop& hole : polygon.holes) {
      progress.check();
      part.holes.push_back(sidesOf({hole, numbers}));
    }
  }
  return parts;
}

/// Strictly larger both ways: only then the other set has room inside without filling it.
bool hasRoom(const LoopSides& hole, const LoopSides& other) {
  return hole.size.x > other.size.x && hole.size.y > other.size.y;
}

template <class Out>
void pairUp(const LoopSides& a, const LoopSides& b, Out& edges, const Progress& progress) {
  addPairs(a.edges, b.corners, Closed::First, edges, progress);
  addPairs(b.edges, a.corners, Closed::Last, edges, progress);
}

template <class Out>
void pairUp(const PartSides& a, const PartSides& b, Out& edges, const Progress& progress) {
  pairUp(a.outer, b.outer, edges, progress);
  for (const LoopSides& hole : b.holes)
    if (hasRoom(hole, a.outer)) pairUp(a.outer, hole, edges, progress);
  for (const LoopSides& hole : a.holes)
    if (hasRoom(hole, b.outer)) pairUp(hole, b.outer, edges, progress);
}

/// Every share of the pairings makes a pile of its own; the shares are the same for any number of cores.
EdgePile paired(const std::vector<Pairing>& pairings, const Effort& effort, const CertainInside* inside,
                const Progress& progress) {
  constexpr std::size_t shares = 8, fewPairings = 4;
  std::vector<std::optional<EdgePile>> piles(pairings.size() <= fewPairings ? 1 : std::min(shares, pairings.size()));
  std::atomic<std::size_t> done = 0;
  parallelFor(piles.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      EdgePile& pile = piles[k].emplace(effort, inside, progress);
      const std::size_t end = pairings.size() * (k + 1) / piles.size();
      for (std::size_t i = pairings.size() * k / piles.size(); i < end; ++i) {
        addPairs(*pairings[i].edges, pairings[i].corners, pairings[i].closed, pile, progress);
        progress.report(static_cast<double>(++done) / static_cast<double>(pairings.size()), "Pairing edges");
      }
    }
  });
  for (std::size_t k = 1; k < piles.size(); ++k) {
    piles[0]->add(*std::move(piles[k]));
    piles[k].reset();
  }
  return *std::move(piles[0]);
}

}  // namespace

namespace {

void sortByEnds(std::vector<CountedEdge>& edges, const Progress& progress) {
  const auto before = [](const CountedEdge& a, const CountedEdge& b) {
    return std::tie(a.from, a.to) != std::tie(b.from, b.to) ? std::tie(a.from, a.to) < std::tie(b.from, b.to)
                                                            : std::uint32_t{a.source} < std::uint32_t{b.source};
  };
  sortInQuarters(edges, before, progress);
}

}  // namespace

void joinEqual(std::vector<CountedEdge>& edges, const Progress& progress) {
  for (CountedEdge& edge : edges)
    if (edge.to < edge.from) {
      std::swap(edge.from, edge.to);
      edge.count = -edge.count;
    }
  sortByEnds(edges, progress);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    CountedEdge sum = edges[i];
    for (++i; i < edges.size() && edges[i].from == sum.from && edges[i].to == sum.to; ++i) {
      sum.count += edges[i].count;
      sum.mayBound |= edges[i].mayBound;
      if (sum.source == 0) sum.source = edges[i].source;
    }
    if (sum.count != 0) edges[kept++] = sum;
  }
  edges.resize(kept);
}

std::vector<CountedEdge> convolution(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                     const Progress& progress, const Effort& effort, PairSources* sources,
                                     const CertainInside* inside) {
  const std::vector<PartSides> partsA = partsOf(a, sources ? &sources->first : nullptr, progress),
                               partsB = partsOf(b, sources ? &sources->second : nullptr, progress);
  PairingList pairings;
  for (const PartSides& partA : partsA)
    for (const PartSides& partB : partsB) pairUp(partA, partB, pairings, progress);
  return std::move(paired(pairings.all, effort, inside, progress)).joined(sources);
}

double pairCount(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress& progress) {
  const std::vector<PartSides> partsA = partsOf(a, nullptr, progress), partsB = partsOf(b, nullptr, progress);
  PairTally tally;
  for (const PartSides& partA : partsA)
    for (const PartSides& partB : partsB) pairUp(partA, partB, tally, progress);
  return tally.count;
}

std::vector<EdgeAtCorner> pairsOf(const GridLoop& a, const GridLoop& b, const Progress& progress) {
  PairList pairs;
  pairUp(sidesOf({a}), sidesOf({b}), pairs, progress);
  return std::move(pairs.all);
}

}  // namespace blossom::planar
