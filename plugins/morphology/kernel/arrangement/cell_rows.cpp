#include "kernel/arrangement/cell_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

#include "core/parallel.h"
#include "geometry/mesh/closed_triangles.h"
#include "geometry/numeric/union_find.h"

namespace blossom::morphology::arrangement {

void CellRows::mark(Cell low, Cell high) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::max(low[k], 0);
    high[k] = std::min(high[k], cells_[k] - 1);
    if (low[k] > high[k]) return;
  }
  const Row marked = bits(low[0], high[0]);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y) row(y, z) |= marked;
}

bool CellRows::all(const Cell& low, const Cell& high) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (low[k] < 0 || high[k] >= cells_[k]) return false;
  const Row asked = bits(low[0], high[0]);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      if ((row(y, z) & asked) != asked) return false;
  return true;
}

namespace {

/// A convex polygon in cells: a triangle cut by a layer and a row, four times. A cut adds one corner, or where rounding
/// makes a side zigzag across it, half as many as there are: no more than thirteen in the end.
struct Piece {
  std::array<Eigen::Vector3d, 13> corners;  // not set beyond `count`
  std::size_t count = 0;

  Piece() = default;
  explicit Piece(const Triangle3& t) : corners{t[0], t[1], t[2]}, count(3) {}
  void add(const Eigen::Vector3d& p) { corners[count++] = p; }
  [[nodiscard]] std::array<int, 2> cellsAlong(Eigen::Index axis) const {
    double low = corners[0][axis], high = low;
    for (std::size_t k = 1; k < count; ++k) {
      low = std::min(low, corners[k][axis]);
      high = std::max(high, corners[k][axis]);
    }
    return {static_cast<int>(std::floor(low - roundingInCells)), static_cast<int>(std::floor(high + roundingInCells))};
  }
};

/// The part on one side of `at`, that of `sign`. Corners on borders are as far off as they are rounded along an edge, so
/// what lies within the layer or row itself is kept.
Piece cutAt(const Piece& piece, Eigen::Index axis, double at, double sign) {
  Piece kept;
  for (std::size_t k = 0; k < piece.count; ++k) {
    const Eigen::Vector3d &from = piece.corners[k], &to = piece.corners[k + 1 == piece.count ? 0 : k + 1];
    const double here = sign * (from[axis] - at), there = sign * (to[axis] - at);
    if (here >= 0) kept.add(from);
    if ((here < 0) != (there < 0)) kept.add(from + (to - from) * (here / (here - there)));
  }
  return kept;
}

/// The part within cells of that number along an axis, and a little beside them.
Piece within(const Piece& piece, Eigen::Index axis, int cell) {
  return cutAt(cutAt(piece, axis, cell - roundingInCells, 1), axis, cell + 1 + roundingInCells, -1);
}

/// Marks the cells that a triangle touches, and some beside it.
void markTouched(const Triangle3& triangle, CellRows& touched) {
  const Piece whole(triangle);
  const auto layers = whole.cellsAlong(2);
  for (int z = std::max(layers[0], 0); z <= std::min(layers[1], touched.cells()[2] - 1); ++z) {
    const Piece layer = layers[0] == layers[1] ? whole : within(whole, 2, z);
    if (layer.count == 0) continue;
    const auto rows = layer.cellsAlong(1);
    for (int y = std::max(rows[0], 0); y <= std::min(rows[1], touched.cells()[1] - 1); ++y) {
      const Piece row = rows[0] == rows[1] ? layer : within(layer, 1, y);
      if (row.count == 0) continue;
      const auto [first, last] = row.cellsAlong(0);
      touched.mark({first, y, z}, {last, y, z});
    }
  }
}

CellRows touchedCells(const std::vector<Triangle3>& triangles, const std::array<int, 3>& cells, const Progress& progress) {
  CellRows touched(cells);
  std::mutex one;
  parallelFor(triangles.size(), 64, progress, [&](std::size_t first, std::size_t last) {
    CellRows here(cells);
    for (std::size_t t = first; t < last; ++t) {
      progress.check();
      markTouched(triangles[t], here);
    }
    const std::scoped_lock lock(one);
    touched.add(here);
  });
  return touched;
}

/// Neighbouring cells of a row that no face touches.
struct Run {
  int y, z, first, last;
};

/// Where the runs of each row begin, row after row, and the end.
struct Runs {
  std::vector<Run> all;
  std::vector<std::size_t> starts;
};

Runs untouchedRuns(const CellRows& touched) {
  Runs runs;
  const auto [nx, ny, nz] = touched.cells();
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y) {
      runs.starts.push_back(runs.all.size());
      CellRows::Row left = ~touched.row(y, z) & CellRows::bits(0, nx - 1);
      while (left != 0) {
        const int first = std::countr_zero(left), last = first + std::countr_one(left >> first) - 1;
        runs.all.push_back({y, z, first, last});
        left &= ~CellRows::bits(first, last);
      }
    }
  runs.starts.push_back(runs.all.size());
  return runs;
}

/// Runs that have sides of cells in common are one group.
UnionFind groupsOf(const Runs& runs, int rowsOfLayer) {
  UnionFind groups(runs.all.size());
  const auto join = [&](std::size_t row, std::size_t other) {
    std::size_t k = runs.starts[other];
    for (std::size_t i = runs.starts[row]; i < runs.starts[row + 1]; ++i) {
      while (k < runs.starts[other + 1] && runs.all[k].last < runs.all[i].first) ++k;
      for (std::size_t j = k; j < runs.starts[other + 1] && runs.all[j].first <= runs.all[i].last; ++j) groups.unite(i, j);
    }
  };
  const auto rows = runs.starts.size() - 1, ofLayer = static_cast<std::size_t>(rowsOfLayer);
  for (std::size_t row = 0; row < rows; ++row) {
    if (row % ofLayer != 0) join(row, row - 1);
    if (row >= ofLayer) join(row, row - ofLayer);
  }
  return groups;
}

}  // namespace

CellRows fullCells(const Features& shape, bool insideOut, const CellFrame& frame, const Progress& progress) {
  std::vector<Triangle3> triangles;
  triangles.reserve(shape.faces.size());
  for (const Features::Face& face : shape.faces) {
    const auto at = [&](std::size_t k) { return frame.inCells(shape.points[static_cast<std::size_t>(face.corners[k])]); };
    triangles.push_back({at(0), at(1), at(2)});
  }
  const CellRows touched = touchedCells(triangles, frame.cells, progress);
  const Runs runs = untouchedRuns(touched);
  UnionFind groups = groupsOf(runs, frame.cells[1]);
  std::vector<std::size_t> longest(runs.all.size());
  std::vector<int> count(runs.all.size(), 0);  // of cells
  const auto length = [&](std::size_t run) { return runs.all[run].last - runs.all[run].first + 1; };
  for (std::size_t i = 0; i < runs.all.size(); ++i) {
    const std::size_t group = groups.find(i);
    if (count[group] == 0 || length(i) > length(longest[group])) longest[group] = i;
    count[group] += length(i);
  }
  constexpr int fewest = 8;  // smaller groups cover too little for a winding number
  std::vector<bool> isFull(runs.all.size(), false);
  CellRows full(frame.cells);
  for (std::size_t i = 0; i < runs.all.size(); ++i) {
    const std::size_t group = groups.find(i);
    if (group == i && count[i] >= fewest) {
      const Run& run = runs.all[longest[i]];
      const int column = (run.first + run.last) / 2;
      const Vec3 middle(0.5 + column, 0.5 + run.y, 0.5 + run.z);
      const double winding = windingNumber(triangles, middle, progress);
      isFull[i] = insideOut ? std::abs(winding) < 0.5 : winding > 0.5;
    }
    if (isFull[group]) full.row(runs.all[i].y, runs.all[i].z) |= CellRows::bits(runs.all[i].first, runs.all[i].last);
  }
  return full;
}

}  // namespace blossom::morphology::arrangement
