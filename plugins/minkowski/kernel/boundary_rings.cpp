#include "kernel/boundary_rings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/error.h"
#include "kernel/wide_products.h"

namespace blossom::minkowski {
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

/// A ring as the numbers of its pieces, which each begin in another corner.
struct RingOfPieces {
  std::vector<std::size_t> pieces;
  double area = 0;
};

class Joiner {
 public:
  Joiner(std::span<const BoundaryPiece> pieces, std::span<const CountedEdge> edges, const Progress& progress)
      : pieces_(pieces), edges_(edges), progress_(progress) {}

  Polygons run() {
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
      from_.push_back(numberOf(piece.from));
      to_.push_back(numberOf(piece.to));
    }
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
    RingOfPieces ring;
    ring.pieces.assign(open.begin() + static_cast<std::ptrdiff_t>(since), open.end());
    for (const std::size_t piece : ring.pieces) place[from_[piece]] = none;
    open.resize(since);
    const Vec2 origin = pieces_[ring.pieces.front()].fromAt;
    double perimeter = 0;
    for (const std::size_t piece : ring.pieces) {
      const Vec2 a = pieces_[piece].fromAt - origin, b = pieces_[piece].toAt - origin;
      ring.area += cross(a, b) / 2;
      perimeter += (b - a).norm();
    }
    constexpr double narrow = 5e-4;  // half a width; rounding decides there which way a ring runs
    if (std::abs(ring.area) > narrow * perimeter) rings_.push_back(std::move(ring));
  }

  [[nodiscard]] Loop loopOf(const RingOfPieces& ring) const {
    Loop loop;
    loop.reserve(ring.pieces.size());
    for (const std::size_t piece : ring.pieces) loop.push_back(pieces_[piece].fromAt);
    return loop;
  }

  Polygons parts() {
    Polygons result;
    std::vector<std::size_t> partOf(rings_.size(), none);
    bool holes = false;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (rings_[i].area < 0) {
        holes = true;
        continue;
      }
      partOf[i] = result.size();
      result.push_back({loopOf(rings_[i]), {}});
    }
    if (!holes) return result;
    findNeighboursBelow();
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (rings_[i].area > 0) continue;
      std::size_t around = below_[i];
      // What is just below a hole is inside: it belongs to the ring there, or to what that one is a hole of.
      for (std::size_t steps = 0; around != none && rings_[around].area < 0; around = below_[around])
        if (++steps > rings_.size()) brokenRing();
      if (around != none) result[partOf[around]].holes.push_back(loopOf(rings_[i]));
    }
    return result;
  }

  /// y of a piece at a half-integer, from `base` on.
  [[nodiscard]] Fraction heightOf(std::size_t piece, std::int64_t twiceX, std::int64_t base) const {
    const CountedEdge& edge = edges_[pieces_[piece].edge];
    return heightAt(edge.from, edge.to, twiceX, base);
  }

  /// A piece of the ring and twice a half-integer within it, as near to the ring's lowest corner as there is one: what is
  /// below that corner begins lower, so that going down from ring to ring comes to an end. Nothing for a ring so narrow.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::int64_t>> lineThrough(const RingOfPieces& ring) const {
    const std::size_t n = ring.pieces.size();
    std::size_t lowest = 0;
    const auto y = [&](std::size_t k) { return pieces_[ring.pieces[k]].fromAt.y(); };
    for (std::size_t k = 1; k < n; ++k)
      if (y(k) < y(lowest)) lowest = k;
    for (std::size_t step = 0; step < n; ++step)
      for (const std::size_t k : {(lowest + step) % n, (lowest + 2 * n - 1 - step) % n}) {
        const BoundaryPiece& piece = pieces_[ring.pieces[k]];
        const bool ahead = k == (lowest + step) % n;
        const double near = ahead ? piece.fromAt.x() : piece.toAt.x(), far = ahead ? piece.toAt.x() : piece.fromAt.x();
        if (std::abs(far - near) < 2) continue;
        const auto unit = static_cast<std::int64_t>(std::floor(far > near ? near + 0.25 : near - 1.25));
        return std::pair{ring.pieces[k], 2 * unit + 1};
      }
    return std::nullopt;
  }

  /// For every hole the ring of the piece that is next below it, on a vertical line through the hole.
  void findNeighboursBelow() {
    struct Entry {
      double low, high;
      std::size_t piece, ring;
    };
    std::vector<Entry> entries;
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (std::size_t r = 0; r < rings_.size(); ++r)
      for (const std::size_t piece : rings_[r].pieces) {
        const double a = pieces_[piece].fromAt.x(), b = pieces_[piece].toAt.x();
        left = std::min({left, a, b});
        right = std::max({right, a, b});
        if (a != b) entries.push_back({std::min(a, b), std::max(a, b), piece, r});
      }
    const auto slabs = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(entries.size())), 1.0, 2000.0));
    const auto slabOf = [&](double x) {
      return std::min(slabs - 1, static_cast<std::size_t>((x - left) / (right - left) * static_cast<double>(slabs)));
    };
    std::vector<std::vector<std::size_t>> inSlab(slabs);
    for (std::size_t e = 0; e < entries.size(); ++e)
      for (std::size_t s = slabOf(entries[e].low); s <= slabOf(entries[e].high); ++s) inSlab[s].push_back(e);
    below_.assign(rings_.size(), none);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].area > 0) continue;
      progress_.check();
      const std::optional<std::pair<std::size_t, std::int64_t>> line = lineThrough(rings_[r]);
      if (!line) continue;
      const auto [piece, twice] = *line;
      const double x = static_cast<double>(twice) / 2;
      const std::int64_t base = edges_[pieces_[piece].edge].from.y;
      Fraction lowest = heightOf(piece, twice, base);
      std::optional<Fraction> highest;
      const auto& candidates = inSlab[slabOf(x)];
      const auto passes = [&](const Entry& entry) { return entry.low < x && x < entry.high; };
      for (const std::size_t e : candidates)
        if (entries[e].ring == r && passes(entries[e])) {
          const Fraction y = heightOf(entries[e].piece, twice, base);
          if (compare(y, lowest) < 0) lowest = y;
        }
      for (const std::size_t e : candidates) {
        if (entries[e].ring == r || !passes(entries[e])) continue;
        const Fraction y = heightOf(entries[e].piece, twice, base);
        if (compare(y, lowest) > 0 || (highest && compare(y, *highest) <= 0)) continue;
        highest = y;
        below_[r] = entries[e].ring;
      }
    }
  }

  std::span<const BoundaryPiece> pieces_;
  std::span<const CountedEdge> edges_;
  const Progress& progress_;
  std::vector<std::size_t> from_, to_, firstOut_, nextOut_, below_;
  std::vector<RingOfPieces> rings_;
};

}  // namespace

Polygons joinedPieces(std::span<const BoundaryPiece> pieces, std::span<const CountedEdge> edges, const Progress& progress) {
  if (pieces.empty()) return {};
  return Joiner(pieces, edges, progress).run();
}

}  // namespace blossom::minkowski
