#include "geometry/planar/winding/boundary_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/error.h"
#include "geometry/planar/winding/ring_nesting.h"

namespace blossom::planar {
namespace {

constexpr std::size_t none = ~std::size_t(0);

[[noreturn]] void brokenRing() {
  throw Error(ErrorCode::Internal, "The boundary of a sum does not close.", "Please report this with the shapes.");
}

struct NameHash {
  std::size_t operator()(const CornerName& name) const {
    auto h = static_cast<std::uint64_t>(name.first) * 0x9E3779B97F4A7C15U;
    h ^= (static_cast<std::uint64_t>(name.second) + (name.crossing ? 0x51ED270B : 0)) * 0xC2B2AE3D27D4EB4FU;
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
};

/// How far from its place a crossing of edges may be rounded, at most.
double roundingOf(std::span<const CountedEdge> edges) {
  std::int64_t reach = 1;
  for (const CountedEdge& e : edges)
    for (const std::int64_t c : {e.from.x, e.from.y, e.to.x, e.to.y}) reach = std::max(reach, std::abs(c));
  return 4 * std::numeric_limits<double>::epsilon() * static_cast<double>(reach);
}

class Joiner {
 public:
  Joiner(std::span<const BoundaryPiece> pieces, std::span<const CountedEdge> edges, const Progress& progress)
      : pieces_(pieces), edges_(edges), progress_(progress), rounding_(roundingOf(edges)) {}

  std::vector<TracedPart> run() {
    nameCorners();
    walkAll();
    return parts();
  }

 private:
  void nameCorners() {
    std::unordered_map<CornerName, std::size_t, NameHash> numbers;
    numbers.reserve(pieces_.size());
    const auto numberOf = [&](const CornerName& name) { return numbers.try_emplace(name, numbers.size()).first->second; };
    for (const BoundaryPiece& piece : pieces_) {
      progress_.check();
      from_.push_back(numberOf(piece.from));
      to_.push_back(numberOf(piece.to));
    }
    // The edges that meet in a corner round it differently.
    corners_.resize(numbers.size());
    for (std::size_t i = pieces_.size(); i-- > 0;) corners_[from_[i]] = pieces_[i].fromAt;
    // The pieces that leave each corner, in a list.
    firstOut_.assign(numbers.size(), none);
    nextOut_.assign(pieces_.size(), none);
    for (std::size_t i = pieces_.size(); i-- > 0;) {
      nextOut_[i] = firstOut_[from_[i]];
      firstOut_[from_[i]] = i;
    }
  }

  [[nodiscard]] GridPoint directionOf(std::size_t piece) const {
    const CountedEdge& edge = edges_[pieces_[piece].edge];
    return pieces_[piece].forward ? edge.to - edge.from : edge.from - edge.to;
  }

  /// 0: along `from`, 1: less than half a turn clockwise, 2: half a turn, 3: more.
  static int quarter(const GridPoint& from, const GridPoint& to) {
    const Wide turn = cross(from, to);
    if (turn != 0) return turn < 0 ? 1 : 3;
    return dot(from, to) > 0 ? 0 : 2;
  }

  /// Clockwise from the way back, around the inside: the first piece that leaves.
  [[nodiscard]] std::size_t following(std::size_t piece) const {
    std::size_t best = firstOut_[to_[piece]];
    if (best == none) brokenRing();
    if (nextOut_[best] == none) return best;
    const GridPoint ahead = directionOf(piece), back{-ahead.x, -ahead.y};
    for (std::size_t other = nextOut_[best]; other != none; other = nextOut_[other]) {
      const GridPoint a = directionOf(best), b = directionOf(other);
      const int qa = quarter(back, a), qb = quarter(back, b);
      if (qb != qa ? qb < qa : cross(a, b) > 0) best = other;
    }
    return best;
  }

  void walkAll() {
    std::vector<bool> done(pieces_.size(), false);
    std::vector<std::size_t> place(firstOut_.size(), none);
    for (std::size_t start = 0; start < pieces_.size(); ++start) {
      if (done[start]) continue;
      progress_.check();
      std::vector<std::size_t> open;
      for (std::size_t piece = start; !done[piece]; piece = following(piece)) {
        done[piece] = true;
        if (place[from_[piece]] != none) cutBack(open, place, from_[piece]);
        place[from_[piece]] = open.size();
        open.push_back(piece);
      }
      if (to_[open.back()] != from_[open.front()]) brokenRing();
      cutBack(open, place, from_[open.front()]);
    }
  }

  /// What was walked since a corner is a ring.
  void cutBack(std::vector<std::size_t>& open, std::vector<std::size_t>& place, std::size_t corner) {
    const std::size_t since = place[corner];
    if (to_[open.back()] != corner) brokenRing();
    Ring ring;
    ring.pieces.assign(open.begin() + static_cast<std::ptrdiff_t>(since), open.end());
    for (const std::size_t piece : ring.pieces) place[from_[piece]] = none;
    open.resize(since);
    const Loop loop = loopOf(ring);
    ring.area = signedArea(loop);
    // Where a ring is narrower than the rounding of its corners, that decides which way it runs.
    if (std::abs(ring.area) > rounding_ * perimeter(loop)) rings_.push_back(std::move(ring));
  }

  [[nodiscard]] Loop loopOf(const Ring& ring) const {
    Loop loop;
    loop.reserve(ring.pieces.size());
    for (const std::size_t piece : ring.pieces) loop.push_back(corners_[from_[piece]]);
    return loop;
  }

  [[nodiscard]] TracedLoop tracedLoop(const Ring& ring) const {
    TracedLoop loop{loopOf(ring), {}};
    loop.edges.reserve(ring.pieces.size());
    for (const std::size_t piece : ring.pieces) loop.edges.push_back(pieces_[piece].edge);
    return loop;
  }

  [[nodiscard]] std::vector<TracedPart> parts() const {
    std::vector<TracedPart> result;
    std::vector<std::size_t> number(rings_.size(), none);
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (rings_[i].area < 0) continue;
      number[i] = result.size();
      result.push_back({tracedLoop(rings_[i]), {}});
    }
    if (result.size() == rings_.size()) return result;
    const std::vector<std::size_t> around = partsAround(rings_, pieces_, edges_, progress_);
    for (std::size_t i = 0; i < rings_.size(); ++i)
      if (around[i] != noRing) result[number[around[i]]].holes.push_back(tracedLoop(rings_[i]));
    return result;
  }

  std::span<const BoundaryPiece> pieces_;
  std::span<const CountedEdge> edges_;
  const Progress& progress_;
  double rounding_;
  std::vector<std::size_t> from_, to_, firstOut_, nextOut_;
  std::vector<Vec2> corners_;
  std::vector<Ring> rings_;
};

}  // namespace

std::vector<TracedPart> joinedPieces(std::span<const BoundaryPiece> pieces, std::span<const CountedEdge> edges,
                                     const Progress& progress) {
  if (pieces.empty()) return {};
  return Joiner(pieces, edges, progress).run();
}

}  // namespace blossom::planar
