#include "geometry/planar/winding/certain_inside.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/full_cells.h"

namespace blossom::planar {
namespace {

using Word = BitRaster::Word;
constexpr int bitsOfWord = BitRaster::wordBits;

struct SetSize {
  GridPoint low, high;
  std::size_t corners = 0;
  double perimeter = 0;  ///< by the larger coordinate of each side
  double area = 0;       ///< twice
  std::int64_t longest = 0;

  void add(const GridLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const GridPoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
      if (corners++ == 0) low = high = p;
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      const std::int64_t length = std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
      longest = std::max(longest, length);
      perimeter += static_cast<double>(length);
      area += static_cast<double>(cross(p, q));
    }
  }
  [[nodiscard]] GridPoint extent() const { return high - low; }
};

SetSize sizeOf(std::span<const GridPolygon> polygons) {
  SetSize size;
  for (const GridPolygon& polygon : polygons) {
    size.add(polygon.outer);
    for (const GridLoop& hole : polygon.holes) size.add(hole);
  }
  return size;
}

constexpr int mostCells = 8192;  // along a side
constexpr int fewestCells = 64;

/// The smallest cells whose marking takes no longer than the pairs do.
std::optional<int> shiftFor(const SetSize& still, const SetSize& moving, double pairs, const CertainInsideOptions& options) {
  const GridPoint extent = still.extent() + moving.extent();
  const auto side = static_cast<double>(std::max(extent.x, extent.y));
  constexpr int smallest = 4;  // several times the rounding of what is computed with cells
  if (side < std::ldexp(fewestCells, smallest)) return std::nullopt;
  int shift = std::max(static_cast<int>(std::ceil(std::log2(side / mostCells))), smallest);
  const auto work = [&](int s) {
    const double size = std::ldexp(1.0, s), rows = std::max(static_cast<double>(extent.y) / size, 16.0);
    const double along = moving.perimeter / size;
    const double stamps = std::min(along + static_cast<double>(moving.corners), 8 * along);
    constexpr double openWords = 6;  // of a row that is almost wholly inside
    constexpr double crossing = 16;  // of a row by a side
    return openWords * rows * stamps + crossing * (still.perimeter / size + along);
  };
  constexpr double mostCrossings = 3e7;  // some hundred megabytes
  const auto crossings = [&](int s) { return std::ldexp(still.perimeter + moving.perimeter, -s); };
  while (work(shift) > options.wordsOfPair * pairs || crossings(shift) > mostCrossings) ++shift;
  if (side < std::ldexp(fewestCells, shift)) return std::nullopt;
  return shift;
}

/// For each cell whether it and its neighbours to the right, above and at both are true.
BitRaster blocks(const BitRaster& full) {
  BitRaster result(full.columns(), full.rows());
  for (int r = 0; r + 1 < full.rows(); ++r)
    for (int w = 0; w < full.words(); ++w) {
      const auto pairsOfRow = [&](const Word* row) {
        const Word next = w + 1 < full.words() ? row[w + 1] : 0;
        return row[w] & (row[w] >> 1 | next << (bitsOfWord - 1));
      };
      result.row(r)[w] = pairsOfRow(full.row(r)) & pairsOfRow(full.row(r + 1));
    }
  return result;
}

/// The words of each row that are not 0: [first, last).
std::vector<std::pair<int, int>> usedWords(const BitRaster& raster) {
  std::vector<std::pair<int, int>> used;
  for (int r = 0; r < raster.rows(); ++r) {
    const Word *const row = raster.row(r), *const end = row + raster.words();
    const auto isUsed = [](Word w) { return w != 0; };
    const Word* const first = std::find_if(row, end, isUsed);
    const Word* last = end;
    while (last > first && !isUsed(last[-1])) --last;
    used.emplace_back(static_cast<int>(first - row), static_cast<int>(last - row));
  }
  return used;
}

/// A raster at many places, which are sorted by rows.
struct Stamps {
  const BitRaster& raster;
  const std::vector<std::pair<int, int>>& used;  ///< words
  const std::vector<BoundaryCell>& places;
};

/// A row of the union, as long as something of it is open.
void uniteRow(const Stamps& stamps, int r, BitRaster& result) {
  const BitRaster& raster = stamps.raster;
  const std::vector<BoundaryCell>& places = stamps.places;
  constexpr std::size_t turns = 16;  // by which each part of the boundary is soon met
  Word* const row = result.row(r);
  std::vector<int> open;
  for (int w = 0; w < result.words(); ++w)
    if (row[w] != ~Word{0}) open.push_back(w);
  const auto placeOf = [&](int firstRow) {
    const auto before = [&](const BoundaryCell& cell) { return cell.row < firstRow; };
    return static_cast<std::size_t>(std::partition_point(places.begin(), places.end(), before) - places.begin());
  };
  const std::size_t first = placeOf(r - raster.rows()), last = placeOf(r);
  for (std::size_t turn = 0; turn < turns && !open.empty(); ++turn) {
    for (std::size_t i = first + turn; i < last; i += turns) {
      const int from = r - places[i].row - 1;
      const auto [begin, end] = stamps.used[static_cast<std::size_t>(from)];
      const Word* const source = raster.row(from);
      const int whole = (places[i].column + 1) / bitsOfWord, bits = (places[i].column + 1) % bitsOfWord;
      for (auto w = std::lower_bound(open.begin(), open.end(), begin + whole); w != open.end() && *w <= end + whole; ++w) {
        const int s = *w - whole;
        const Word here = s < raster.words() ? source[s] : 0, before = s > 0 ? source[s - 1] : 0;
        row[*w] |= bits == 0 ? here : here << bits | before >> (bitsOfWord - bits);
      }
    }
    std::erase_if(open, [&](int w) { return row[w] == ~Word{0}; });
  }
}

/// Marks what the full cells cover when they are moved to all places.
void unite(const BitRaster& full, const std::vector<BoundaryCell>& places, const Progress& progress, BitRaster& result) {
  const std::vector<std::pair<int, int>> used = usedWords(full);
  parallelFor(static_cast<std::size_t>(result.rows()), 16, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) uniteRow({full, used, places}, static_cast<int>(r), result);
  });
  progress.check();
}

/// Cells along a boundary, a quarter of the raster's size apart and no more of them than can be stamped with so many words.
std::vector<BoundaryCell> placesFor(const BitRaster& stamp, std::span<const GridPolygon> polygons, const CellFrame& frame,
                                    double words) {
  std::vector<BoundaryCell> places =
      boundaryCells(polygons, frame, std::max(std::min(stamp.columns(), stamp.rows()) / 4.0, 1.0));
  constexpr double search = 10;  // words, of a row of the stamp at a place
  const double work = static_cast<double>(places.size()) * stamp.rows() * (stamp.words() + search);
  auto step = static_cast<std::size_t>(std::ceil(work / words));
  if (step <= 1) return places;
  step |= 1;  // of two places in every row not always the same one
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); i += step) places[kept++] = places[i];
  places.resize(kept);
  return places;
}

/// Parts of runs that touch, also at corners.
class RunParts {
 public:
  explicit RunParts(const std::vector<BitRun>& runs) : part_(runs.size()) {
    std::iota(part_.begin(), part_.end(), std::size_t{0});
    std::size_t below = 0, row = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i].row != runs[row].row) {
        below = runs[i].row == runs[row].row + 1 ? row : i;
        row = i;
      }
      while (below < row && runs[below].last < runs[i].first) ++below;
      for (std::size_t k = below; k < row && runs[k].first <= runs[i].last; ++k) join(k, i);
    }
  }
  /// Whether they were two.
  bool join(std::size_t i, std::size_t k) {
    const std::size_t one = of(i), other = of(k);
    part_[one] = other;
    return one != other;
  }

 private:
  std::size_t of(std::size_t i) {
    while (part_[i] != i) i = part_[i] = part_[part_[i]];
    return i;
  }

  std::vector<std::size_t> part_;
};

BitRaster complementOf(const BitRaster& cells) {
  BitRaster rest(cells.columns(), cells.rows());
  for (int r = 0; r < cells.rows(); ++r) {
    std::transform(cells.row(r), cells.row(r) + cells.words(), rest.row(r), [](Word w) { return ~w; });
    rest.set(r, cells.columns(), cells.words() * bitsOfWord, false);
  }
  return rest;
}

/// Opens every hole by the shortest cuts along rows that leave none closed. Every row begins outside, so cuts to the left
/// lead there, over other holes perhaps. @pre no cell of the first column is inside
void openHoles(BitRaster& cells) {
  const std::vector<BitRun> gaps = runsOf(complementOf(cells));
  RunParts parts(gaps);
  std::optional<std::size_t> outside;
  std::vector<std::size_t> cuts;  // each to the left of a gap
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].row == 0 || gaps[i].row == cells.rows() - 1 || gaps[i].first == 0 || gaps[i].last == cells.columns()) {
      if (outside) parts.join(i, *outside);
      outside = i;
    }
    if (i > 0 && gaps[i - 1].row == gaps[i].row) cuts.push_back(i);
  }
  const auto length = [&](std::size_t i) { return gaps[i].first - gaps[i - 1].last; };
  std::stable_sort(cuts.begin(), cuts.end(), [&](std::size_t i, std::size_t k) { return length(i) < length(k); });
  for (const std::size_t i : cuts)
    if (parts.join(i, i - 1)) cells.set(gaps[i].row, gaps[i - 1].last, gaps[i].first, false);
}

}  // namespace

bool CertainInside::contains(const GridPoint& p, const GridPoint& q) const {
  const CellFrame frame{low_, shift_};
  const auto [left, right] = std::minmax({frame.column(p.x), frame.column(q.x)});
  const auto [below, above] = std::minmax({frame.row(p.y), frame.row(q.y)});
  return cells_.all(left, right, below, above);
}

bool CertainInside::isDeep(const GridPoint& p) const {
  const CellFrame frame{low_, shift_};
  return deep_.at(frame.column(p.x), frame.row(p.y));
}

std::size_t CertainInside::runAt(const GridPoint& p) const {
  const CellFrame frame{low_, shift_};
  const int column = frame.column(p.x);
  const auto& row = runsOfRow_[static_cast<std::size_t>(frame.row(p.y))];
  const auto after =
      std::upper_bound(row.begin(), row.end(), column, [&](int c, std::uint32_t run) { return c < runs_[run].first; });
  return *(after - 1);
}

GridPoint CertainInside::corner(int column, int row) const {
  return low_ + GridPoint{std::int64_t{column} << shift_, std::int64_t{row} << shift_};
}

GridPoint CertainInside::middle(int column, int row) const {
  const std::int64_t half = std::int64_t{1} << (shift_ - 1);
  return corner(column, row) + GridPoint{half, half};
}

// Breadth first from one run of each part, over runs that have columns in common.
void CertainInside::makeRuns() {
  const std::vector<BitRun> all = runsOf(cells_);
  std::vector<std::pair<std::size_t, std::size_t>> rows(static_cast<std::size_t>(cells_.rows()), {0, 0});
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& [first, last] = rows[static_cast<std::size_t>(all[i].row)];
    if (first == last) first = i;
    last = i + 1;
  }
  constexpr auto unseen = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(all.size(), unseen);  // in runs_
  const auto visit = [&](std::size_t i, int parent, int door) {
    place[i] = static_cast<std::uint32_t>(runs_.size());
    runs_.push_back({all[i].row, all[i].first, all[i].last, parent, door});
  };
  for (std::size_t start = 0; start < all.size(); ++start) {
    if (place[start] != unseen) continue;
    std::size_t next = runs_.size();
    visit(start, -1, (all[start].first + all[start].last) / 2);
    for (; next < runs_.size(); ++next)
      for (const int row : {runs_[next].row - 1, runs_[next].row + 1}) {
        if (row < 0 || row >= cells_.rows()) continue;
        const auto [first, last] = rows[static_cast<std::size_t>(row)];
        const auto beside = std::partition_point(all.begin() + static_cast<std::ptrdiff_t>(first),
                                                 all.begin() + static_cast<std::ptrdiff_t>(last),
                                                 [&](const BitRun& run) { return run.last <= runs_[next].first; });
        for (auto k = static_cast<std::size_t>(beside - all.begin()); k < last && all[k].first < runs_[next].last; ++k) {
          const int left = std::max(all[k].first, runs_[next].first), right = std::min(all[k].last, runs_[next].last);
          if (place[k] == unseen) visit(k, static_cast<int>(next), (left + right) / 2);
        }
      }
  }
  runsOfRow_.resize(static_cast<std::size_t>(cells_.rows()));
  for (std::size_t i = 0; i < all.size(); ++i) runsOfRow_[static_cast<std::size_t>(all[i].row)].push_back(place[i]);
}

std::optional<CertainInside> certainInside(std::span<const GridPolygon> a, std::span<const GridPolygon> b,
                                           const Progress& progress, const Effort& effort,
                                           const CertainInsideOptions& options) {
  SetSize still = sizeOf(a), moving = sizeOf(b);
  if (2 * static_cast<double>(still.corners) * static_cast<double>(moving.corners) < options.fewestPairs)
    return std::nullopt;
  const double pairs = pairCount(a, b, progress);
  if (pairs < options.fewestPairs) return std::nullopt;
  constexpr double mostPairs = 2e9;
  if (pairs > mostPairs)
    throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has more than two thousand million edges.",
                "Raise the tolerance, so that curves get fewer corners.");
  constexpr double workOfPair = 2;  // of an edge that is left out
  effort.foresee(workOfPair * pairs);
  if (moving.area > still.area) {
    std::swap(still, moving);
    std::swap(a, b);
  }
  const std::optional<int> shift = shiftFor(still, moving, pairs, options);
  if (!shift) return std::nullopt;
  const auto cellsAlong = [&](std::int64_t length) { return static_cast<int>(length >> *shift) + 2; };
  const GridPoint stillExtent = still.extent(), movingExtent = moving.extent();
  const CellFrame ofStill{still.low, *shift}, ofMoving{moving.low, *shift};
  const auto full = [&](std::span<const GridPolygon> set, const CellFrame& frame, const GridPoint& extent) {
    return blocks(fullCells(set, frame, cellsAlong(extent.x), cellsAlong(extent.y)));
  };
  CertainInside inside;
  inside.low_ = still.low + moving.low;
  inside.shift_ = *shift;
  inside.pairs_ = pairs;
  inside.cells_ = BitRaster(cellsAlong(stillExtent.x) + cellsAlong(movingExtent.x),
                            cellsAlong(stillExtent.y) + cellsAlong(movingExtent.y));
  unite(full(a, ofStill, stillExtent), boundaryCells(b, ofMoving), progress, inside.cells_);
  // Parts of A thinner than a cell have no full ones: there, those of B reach farther.
  const BitRaster core = full(b, ofMoving, movingExtent);
  constexpr double share = 0.25;
  unite(core, placesFor(core, a, ofStill, share * options.wordsOfPair * pairs), progress, inside.cells_);
  openHoles(inside.cells_);
  progress.check();
  const auto longest =
      static_cast<int>(std::min<std::int64_t>(std::max(still.longest, moving.longest) >> *shift, mostCells));
  inside.deep_ = eroded(inside.cells_, longest + 1);
  progress.check();
  inside.makeRuns();
  if (inside.runs_.empty()) return std::nullopt;
  return inside;
}

}  // namespace blossom::planar
