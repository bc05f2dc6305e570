#include "kernel/arrangement/sum_core.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology::arrangement {

namespace {

using Cell = CellRows::Cell;
using Place = Eigen::Vector3d;  // in cells

struct GridBox {
  Grid3 low{}, high{};
};

GridBox gridBoxOf(const Features& shape) {
  GridBox box{shape.points.front(), shape.points.front()};
  for (const Grid3& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  return box;
}

/// With cells to spare on all sides. Corners of shapes on axes seldom lie on borders of cells.
CellFrame frameOf(const GridBox& box, double size) {
  constexpr double before = 1.37;
  CellFrame frame{box.low, size, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    frame.origin[k] -= std::llround(before * size);
    frame.cells[k] = static_cast<int>(static_cast<double>(box.high[k] - frame.origin[k]) / size) + 2;
  }
  return frame;
}

/// Cells of which all eight neighbours towards higher numbers, and they themselves, are full.
CellRows blocks(const CellRows& full) {
  CellRows result(full.cells());
  const auto pairs = [](CellRows::Row row) { return row & row >> 1; };
  for (int z = 0; z + 1 < full.cells()[2]; ++z)
    for (int y = 0; y + 1 < full.cells()[1]; ++y)
      result.row(y, z) = pairs(full.row(y, z) & full.row(y + 1, z) & full.row(y, z + 1) & full.row(y + 1, z + 1));
  return result;
}

/// The cells of some points of the edges, each once. Points on borders are left out: rounding may have put them there.
std::vector<Cell> cellsAlongEdges(const Features& shape, const CellFrame& frame) {
  std::vector<Cell> cells;
  const auto add = [&](const Place& p) {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[static_cast<Eigen::Index>(k)];
      cell[k] = static_cast<int>(std::floor(x));
      if (std::abs(x - std::round(x)) < roundingInCells) return;
    }
    cells.push_back(cell);
  };
  for (const Grid3& p : shape.points) add(frame.inCells(p));
  constexpr double apart = 2;  // cells
  for (const Features::Edge& edge : shape.edges) {
    const Place from = frame.inCells(shape.points[static_cast<std::size_t>(edge.from)]),
                to = frame.inCells(shape.points[static_cast<std::size_t>(edge.to)]);
    const int parts = static_cast<int>((to - from).norm() / apart) + 1;
    for (int k = 1; k < parts; ++k) add(from + (to - from) * k / parts);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  constexpr std::size_t most = 512;
  const std::size_t step = (cells.size() + most - 1) / most;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < cells.size(); k += step) cells[kept++] = cells[k];
  cells.resize(kept);
  return cells;
}

/// Marks what full cells cover when they are moved by a point of each of the cells. A moved cell covers parts of eight, of
/// which the first is one farther along each axis.
void unite(const CellRows& full, const std::vector<Cell>& by, CellRows& result, const Progress& progress) {
  const CellRows stamp = blocks(full);
  parallelFor(static_cast<std::size_t>(result.cells()[2]), 4, progress, [&](std::size_t begin, std::size_t end) {
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (const Cell& move : by) {
        const int from = z - move[2] - 1;
        if (from < 0 || from >= stamp.cells()[2]) continue;
        for (int y = 0; y < stamp.cells()[1]; ++y) result.row(y + move[1] + 1, z) |= stamp.row(y, from) << (move[0] + 1);
      }
  });
}

struct Polygon {
  std::array<Place, 4> corners;
  std::size_t count = 3;
};

/// Triangles and parallelograms, cut at the middles of their sides.
std::array<Polygon, 4> quarters(const Polygon& p) {
  std::array<Polygon, 4> made;
  const auto middle = [&](std::size_t k) -> Place { return (p.corners[k % p.count] + p.corners[(k + 1) % p.count]) / 2; };
  if (p.count == 3) {
    for (std::size_t k = 0; k < 3; ++k) made[k].corners = {p.corners[k], middle(k), middle(k + 2)};
    made[3].corners = {middle(0), middle(1), middle(2)};
    return made;
  }
  const Place centre = (p.corners[0] + p.corners[2]) / 2;
  for (std::size_t k = 0; k < 4; ++k) made[k] = {{p.corners[k], middle(k), centre, middle(k + 3)}, 4};
  return made;
}

bool liesIn(const CellRows& cells, const Polygon& polygon) {
  Place low = polygon.corners[0], high = low;
  for (std::size_t k = 1; k < polygon.count; ++k) {
    low = low.cwiseMin(polygon.corners[k]);
    high = high.cwiseMax(polygon.corners[k]);
  }
  const TouchedCells box(low, high);
  if (cells.all(box.low, box.high)) return true;
  if ((high - low).maxCoeff() <= 1) return false;
  for (const Polygon& part : quarters(polygon))
    if (!liesIn(cells, part)) return false;
  return true;
}

}  // namespace

SumCore::SumCore(const Features& a, const Features& b, bool insideOut, const Progress& progress) {
  GridBox first = gridBoxOf(a);
  const GridBox second = gridBoxOf(b);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t reach = insideOut ? second.high[k] - second.low[k] : 0;
    first.low[k] -= reach;
    first.high[k] += reach;
    longest = std::max(longest, static_cast<double>(first.high[k] - first.low[k] + second.high[k] - second.low[k]));
  }
  constexpr int spare = 7;  // of both frames
  const double size = std::max(longest / (CellRows::longest - spare), 1.0);
  const CellFrame ofFirst = frameOf(first, size), ofSecond = frameOf(second, size);
  frame_ = {ofFirst.origin + ofSecond.origin, size, {}};
  for (std::size_t k = 0; k < 3; ++k) frame_.cells[k] = ofFirst.cells[k] + ofSecond.cells[k];
  inside_ = CellRows(frame_.cells);
  CellRows fullOfFirst, fullOfSecond;
  std::vector<Cell> alongFirst, alongSecond;
  sideBySide(
      progress,
      [&] {
        fullOfFirst = fullCells(a, insideOut, ofFirst, progress);
        alongFirst = cellsAlongEdges(a, ofFirst);
      },
      [&] {
        fullOfSecond = fullCells(b, false, ofSecond, progress);
        alongSecond = cellsAlongEdges(b, ofSecond);
      });
  unite(fullOfFirst, alongSecond, inside_, progress);
  unite(fullOfSecond, alongFirst, inside_, progress);
}

bool SumCore::holds(std::span<const Grid3> corners) const {
  Polygon polygon;
  polygon.count = corners.size();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    polygon.corners[k] = frame_.inCells(corners[k]);
    const TouchedCells cell(polygon.corners[k], polygon.corners[k]);
    if (!inside_.all(cell.low, cell.high)) return false;
  }
  return liesIn(inside_, polygon);
}

}  // namespace blossom::morphology::arrangement
