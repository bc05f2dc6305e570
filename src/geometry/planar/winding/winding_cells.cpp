#include "geometry/planar/winding/winding_cells.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/planar/winding/wide_products.h"

namespace blossom::planar {
namespace {

constexpr double edgesPerCell = 1;
constexpr std::size_t fewEdges = 64;  // below, one cell is quickest
constexpr int longestSide = 4096;

struct Bounds {
  GridPoint low, high;
};

Bounds boundsOf(std::span<const CountedEdge> edges) {
  Bounds box{edges.front().from, edges.front().from};
  for (const CountedEdge& e : edges) {
    box.low = {std::min(box.low.x, e.from.x), std::min({box.low.y, e.from.y, e.to.y})};
    box.high = {std::max(box.high.x, e.to.x), std::max({box.high.y, e.from.y, e.to.y})};
  }
  return box;
}

}  // namespace

template <class Fill>
void WindingCells::forEachShare(int count, std::size_t edges, const Progress& progress, Fill fill) {
  constexpr std::size_t fewForShares = 4096, many = 8;  // each share looks at all edges
  const std::size_t shares = edges < fewForShares ? 1 : many;
  const auto start = [&](std::size_t share) { return static_cast<int>(static_cast<std::size_t>(count) * share / shares); };
  parallelFor(shares, 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t share = begin; share < end; ++share) fill(Columns{start(share), start(share + 1) - 1});
  });
}

WindingCells::WindingCells(std::span<const CountedEdge> edges, WindingRule rule, const Progress& progress) {
  layOut(edges);
  std::vector<Columns> near(edges.size());
  constexpr std::size_t grain = 4096;
  parallelFor(edges.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) near[k] = columnsNear(edges[k]);
  });
  windCorners(edges, near, progress);
  listEdges(edges, near, rule, progress);
}

void WindingCells::layOut(std::span<const CountedEdge> edges) {
  const Bounds box = boundsOf(edges);
  const std::int64_t width = box.high.x - box.low.x + 1, height = box.high.y - box.low.y + 1;
  const auto count = [](std::int64_t side, std::int64_t size) { return (side + size - 1) / size; };
  const auto cellsFor = [&](std::int64_t size) {
    return static_cast<double>(count(width, size)) * static_cast<double>(count(height, size));
  };
  constexpr std::int64_t smallest = 16;  // several times the unit by which lists reach beyond a cell
  std::int64_t size = std::max(width, height);
  const double wanted = edges.size() <= fewEdges ? 1 : static_cast<double>(edges.size()) / edgesPerCell;
  double length = 0;
  for (const CountedEdge& edge : edges)
    length += static_cast<double>(edge.to.x - edge.from.x) + std::abs(static_cast<double>(edge.to.y - edge.from.y));
  constexpr double listed = 4e7;  // entries of all lists: some hundred megabytes
  while (size > smallest && 2 * length <= listed * static_cast<double>(size) && cellsFor(size / 2) <= wanted &&
         std::max(width, height) / (size / 2) < longestSide)
    size /= 2;
  columns_ = CellBorders(box.low.x, box.high.x, size);
  rows_ = CellBorders(box.low.y, box.high.y, size);
  if (edges.size() <= fewEdges) return;
  std::vector<std::int64_t> places(edges.size());
  std::transform(edges.begin(), edges.end(), places.begin(), [](const CountedEdge& e) { return e.from.x; });
  columns_.refine(places, smallest);
  std::transform(edges.begin(), edges.end(), places.begin(), [](const CountedEdge& e) { return e.from.y; });
  rows_.refine(places, smallest);
}

double WindingCells::pairs() const {
  double pairs = 0;
  for (std::size_t i = 0; i + 1 < firsts_.size(); ++i) {
    const auto edges = static_cast<double>(firsts_[i + 1] - firsts_[i]);
    pairs += edges * edges;
  }
  return pairs;
}

int WindingCells::rowAt(const CountedEdge& edge, int border) const {
  const GridPoint by = edge.to - edge.from;
  const std::int64_t x = borderX(border);
  const double run = static_cast<double>(x - 2 * edge.from.x) / (2 * static_cast<double>(by.x));
  const double y = rows_.fromFirst(edge.from.y) + run * static_cast<double>(by.y);
  const int row = rows_.cellAt(y);
  const int nearest = y - rows_.at(row) < rows_.at(row + 1) - y ? row : row + 1;
  if (std::abs(y - rows_.at(nearest)) > 1) return row;
  return sideOf(edge.from, edge.to, x, borderY(nearest)) <= 0 ? nearest : nearest - 1;  // the corner on the edge or below it
}

void WindingCells::windCorners(std::span<const CountedEdge> edges, std::span<const Columns> near, const Progress& progress) {
  corners_.assign(static_cast<std::size_t>(columns_.cells() + 1) * static_cast<std::size_t>(rows_.cells() + 1), 0);
  forEachShare(columns_.cells() + 1, edges.size(), progress, [&](const Columns& share) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (near[k].last < share.first || near[k].first > share.last) continue;
      progress.check();
      const int first = cellOf(edges[k].from).column, last = cellOf(edges[k].to).column;
      for (int border = std::max(first + 1, share.first); border <= std::min(last, share.last); ++border)
        corners_[cornerIndex(border, rowAt(edges[k], border) + 1)] += edges[k].count;
    }
    for (int column = share.first; column <= share.last; ++column)
      for (int row = 1; row <= rows_.cells(); ++row)
        corners_[cornerIndex(column, row)] += corners_[cornerIndex(column, row - 1)];
  });
}

namespace {
constexpr double reach = 1.5;  // a unit, and the rounding of what is computed here
}

WindingCells::Columns WindingCells::columnsNear(const CountedEdge& edge) const {
  const double from = columns_.fromFirst(edge.from.x), to = columns_.fromFirst(edge.to.x);
  return {columns_.cellAt(from - reach), columns_.cellAt(to + reach)};
}

/// All cells within a unit of the edge, and perhaps some more.
template <class Visit>
void WindingCells::forEachCellNear(const CountedEdge& edge, const Columns& of, const Columns& within, Visit visit) const {
  const GridPoint by = edge.to - edge.from;
  const double ax = columns_.fromFirst(edge.from.x), ay = rows_.fromFirst(edge.from.y);
  const double bx = ax + static_cast<double>(by.x), high = ay + static_cast<double>(by.y);
  const double slope = by.x == 0 ? 0 : static_cast<double>(by.y) / static_cast<double>(by.x);
  for (int column = std::max(of.first, within.first); column <= std::min(of.last, within.last); ++column) {
    double from = ay, to = high;
    if (of.first != of.last && by.x != 0) {
      const double left = std::max(ax, columns_.at(column) - reach), right = std::min(bx, columns_.at(column + 1) + reach);
      if (left > ax) from = ay + (left - ax) * slope;
      if (right < bx) to = ay + (right - ax) * slope;
    }
    const int low = rows_.cellAt(std::min(from, to) - reach), top = rows_.cellAt(std::max(from, to) + reach);
    for (int row = low; row <= top; ++row) visit(Cell{column, row});
  }
}

void WindingCells::certify(const Columns& columns, WindingRule rule, std::span<const std::int64_t> changes) {
  for (int column = columns.first; column <= columns.last; ++column)
    for (int row = 0; row < rows_.cells(); ++row) {
      const Cell cell{column, row};
      const std::int64_t winding = windingBelow(column, row), change = changes[index(cell)];
      const bool in = winding - change > rule.high || winding + change < rule.low;
      const bool out = winding - change >= rule.low && winding + change <= rule.high;
      if (in || out) firsts_[index(cell) + 1] = 0;
    }
}

void WindingCells::listEdges(std::span<const CountedEdge> edges, std::span<const Columns> near, WindingRule rule,
                             const Progress& progress) {
  const std::size_t cells = static_cast<std::size_t>(columns_.cells()) * static_cast<std::size_t>(rows_.cells());
  std::vector<std::int64_t> changes(cells, 0);
  firsts_.assign(cells + 1, 0);
  const auto forEachEdge = [&](const Columns& share, auto visit) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (near[k].last < share.first || near[k].first > share.last) continue;
      progress.check();
      forEachCellNear(edges[k], near[k], share, [&](const Cell& cell) { visit(k, index(cell)); });
    }
  };
  forEachShare(columns_.cells(), edges.size(), progress, [&](const Columns& share) {
    forEachEdge(share, [&](std::size_t k, std::size_t cell) {
      changes[cell] += std::abs(edges[k].count);
      ++firsts_[cell + 1];
    });
    certify(share, rule, changes);
  });
  for (std::size_t i = 0; i < cells; ++i) firsts_[i + 1] += firsts_[i];
  lists_.resize(firsts_.back());
  std::vector<std::uint32_t> next(firsts_.begin(), firsts_.end() - 1);
  forEachShare(columns_.cells(), edges.size(), progress, [&](const Columns& share) {
    forEachEdge(share, [&](std::size_t k, std::size_t cell) {
      if (firsts_[cell] != firsts_[cell + 1]) lists_[next[cell]++] = static_cast<std::uint32_t>(k);
    });
  });
}

}  // namespace blossom::planar
