#include "geometry/planar/winding/ring_nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/planar/winding/wide_products.h"

namespace blossom::planar {
namespace {

/// The line x = twice / 2, or y = twice / 2 where it lies level; `twice` is odd, so that no point of the grid lies on it.
struct ProbeLine {
  bool level = false;
  std::int64_t twice = 0;
  [[nodiscard]] double at() const { return static_cast<double>(twice) / 2; }
  [[nodiscard]] double across(const Vec2& p) const { return level ? p.y() : p.x(); }
  [[nodiscard]] double along(const Vec2& p) const { return level ? p.x() : p.y(); }
  [[nodiscard]] GridPoint turned(const GridPoint& p) const { return level ? GridPoint{p.y, p.x} : p; }
};

/// More than the rounding of a corner.
constexpr double roundedWithin = 0.25;

class Nest {
 public:
  Nest(std::span<const Ring> rings, std::span<const BoundaryPiece> pieces, std::span<const CountedEdge> edges,
       const Progress& progress)
      : rings_(rings), pieces_(pieces), edges_(edges), progress_(progress) {}

  std::vector<std::size_t> run() {
    std::vector<std::size_t> around(rings_.size(), noRing);
    for (std::size_t r = 0; r < rings_.size(); ++r)
      if (rings_[r].area < 0) around[r] = partAround(rings_[r]);
    return around;
  }

 private:
  /// Whether an end of a piece lies before a line.
  [[nodiscard]] bool isBefore(const BoundaryPiece& piece, bool start, const ProbeLine& line) const {
    const double rounded = line.across(start ? piece.fromAt : piece.toAt);
    if (std::abs(rounded - line.at()) > roundedWithin) return rounded < line.at();
    const CornerName& name = start ? piece.from : piece.to;
    if (!name.crossing) return 2 * (line.level ? name.second : name.first) < line.twice;
    const CountedEdge &e = edges_[static_cast<std::size_t>(name.first)], &d = edges_[static_cast<std::size_t>(name.second)];
    const GridPoint by = e.to - e.from, along = d.to - d.from;
    const Fraction t = fraction(cross(d.from - e.from, along), cross(by, along));
    const std::int64_t reach = line.twice - 2 * line.turned(e.from).x;
    return compareProducts(t.over, Wide(2) * line.turned(by).x, reach, t.under) < 0;
  }
  [[nodiscard]] bool passes(std::size_t piece, const ProbeLine& line) const {
    const BoundaryPiece& p = pieces_[piece];
    return isBefore(p, true, line) != isBefore(p, false, line);
  }

  /// Whether piece a passes the line below piece b. Corners on the line count as behind it, so in one the order is that just
  /// before the line.
  [[nodiscard]] bool isBelow(std::size_t a, std::size_t b, const ProbeLine& line) const {
    const auto [lowA, highA] = std::minmax({line.along(pieces_[a].fromAt), line.along(pieces_[a].toAt)});
    const auto [lowB, highB] = std::minmax({line.along(pieces_[b].fromAt), line.along(pieces_[b].toAt)});
    if (highA < lowB - 2 * roundedWithin) return true;
    if (lowA > highB + 2 * roundedWithin) return false;
    const CountedEdge &e = edges_[pieces_[a].edge], &d = edges_[pieces_[b].edge];
    const GridPoint from = line.turned(e.from), to = line.turned(e.to), start = line.turned(d.from), end = line.turned(d.to);
    const int order = compare(heightAt(from, to, line.twice, from.y), heightAt(start, end, line.twice, from.y));
    if (order != 0) return order < 0;
    return compare(fraction(to.y - from.y, to.x - from.x), fraction(end.y - start.y, end.x - start.x)) > 0;
  }

  /// The piece of a ring that passes the line lowest.
  [[nodiscard]] std::optional<std::size_t> lowestOn(const ProbeLine& line, const Ring& ring) const {
    std::optional<std::size_t> lowest;
    for (const std::size_t piece : ring.pieces)
      if (passes(piece, line) && (!lowest || isBelow(piece, *lowest, line))) lowest = piece;
    return lowest;
  }

  [[nodiscard]] std::size_t partAround(const Ring& hole) {
    for (const bool level : {false, true}) {
      ProbeLine line{level, 0};
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const std::size_t piece : hole.pieces) {
        low = std::min(low, line.across(pieces_[piece].fromAt));
        high = std::max(high, line.across(pieces_[piece].fromAt));
      }
      for (const int aside : {0, -1}) {  // of a unit that is hardly as wide as the hole
        line.twice = 2 * (static_cast<std::int64_t>(std::floor(low + (high - low) / 2)) + aside) + 1;
        if (const std::optional<std::size_t> piece = lowestOn(line, hole)) return smallestAround(*piece, line);
      }
    }
    return noRing;
  }

  /// Of the rings around parts that a point just below a piece lies in, the smallest.
  [[nodiscard]] std::size_t smallestAround(std::size_t piece, const ProbeLine& line) {
    const Slabs& slabs = slabsOf(line.level);
    odd_.resize(rings_.size(), false);
    touched_.clear();
    for (const std::uint32_t other : slabs.at(line.at())) {
      progress_.check();
      if (!passes(other, line) || !isBelow(other, piece, line)) continue;
      const std::size_t ring = slabs.ringOf[other];
      odd_[ring] = !odd_[ring];
      touched_.push_back(ring);
    }
    std::size_t smallest = noRing;
    for (const std::size_t ring : touched_) {
      if (odd_[ring] && (smallest == noRing || rings_[ring].area < rings_[smallest].area)) smallest = ring;
      odd_[ring] = false;
    }
    return smallest;
  }

  /// The pieces of the rings around parts, in slabs across the lines.
  struct Slabs {
    double low = 0, width = 1;
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<std::size_t> ringOf;  ///< of each piece
    [[nodiscard]] std::size_t index(double x) const {
      const double slab = (x - low) / width;
      return std::min(lists.size() - 1, static_cast<std::size_t>(std::max(slab, 0.0)));
    }
    [[nodiscard]] const std::vector<std::uint32_t>& at(double x) const { return lists[index(x)]; }
  };

  [[nodiscard]] const Slabs& slabsOf(bool level) {
    std::optional<Slabs>& made = slabs_[level ? 1 : 0];
    if (!made) made = slabsAlong({level, 0});
    return *made;
  }

  [[nodiscard]] Slabs slabsAlong(const ProbeLine& line) const {
    Slabs slabs;
    slabs.ringOf.assign(pieces_.size(), noRing);
    double low = HUGE_VAL, high = -HUGE_VAL, length = 0, count = 0;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].area < 0) continue;
      for (const std::size_t piece : rings_[r].pieces) {
        slabs.ringOf[piece] = r;
        const double a = line.across(pieces_[piece].fromAt), b = line.across(pieces_[piece].toAt);
        low = std::min({low, a, b});
        high = std::max({high, a, b});
        length += std::abs(b - a);
        ++count;
      }
    }
    // As many slabs as pieces, unless long pieces would then be listed in many of them.
    constexpr double listed = 4;
    const double size = std::max(high - low, 1.0);
    const double most = length > 0 ? listed * count * size / length : count;
    slabs.lists.resize(static_cast<std::size_t>(std::clamp(std::min(count, most), 1.0, 1e6)));
    slabs.low = low;
    slabs.width = size / static_cast<double>(slabs.lists.size());
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
      if (slabs.ringOf[piece] == noRing) continue;
      progress_.check();
      const auto [from, to] = std::minmax({line.across(pieces_[piece].fromAt), line.across(pieces_[piece].toAt)});
      for (std::size_t s = slabs.index(from - roundedWithin); s <= slabs.index(to + roundedWithin); ++s)
        slabs.lists[s].push_back(static_cast<std::uint32_t>(piece));
    }
    return slabs;
  }

  std::span<const Ring> rings_;
  std::span<const BoundaryPiece> pieces_;
  std::span<const CountedEdge> edges_;
  const Progress& progress_;
  std::array<std::optional<Slabs>, 2> slabs_;
  std::vector<bool> odd_;
  std::vector<std::size_t> touched_;
};

}  // namespace

std::vector<std::size_t> partsAround(std::span<const Ring> rings, std::span<const BoundaryPiece> pieces,
                                     std::span<const CountedEdge> edges, const Progress& progress) {
  return Nest(rings, pieces, edges, progress).run();
}

}  // namespace blossom::planar
