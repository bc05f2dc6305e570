#include "geometry/planar/winding/full_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/parallel.h"

namespace blossom::planar {
namespace {

template <class Visit>
void forEachSide(std::span<const GridPolygon> polygons, Visit visit) {
  const auto sidesOfLoop = [&](const GridLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
  };
  for (const GridPolygon& polygon : polygons) {
    sidesOfLoop(polygon.outer);
    for (const GridLoop& hole : polygon.holes) sidesOfLoop(hole);
  }
}

constexpr double beside = 3;  // units; more than the rounding of what is computed here

/// Some rows of a raster, which one core fills: [first, last).
struct Band {
  int first, last;
};

/// Clears the cells of a band that a side passes within some units.
void clearAlong(const GridPoint& p, const GridPoint& q, const CellFrame& frame, const Band& band, BitRaster& cells) {
  const double size = std::ldexp(1.0, frame.shift);
  const auto& [from, to] = std::minmax(p, q);  // by x
  const auto xOf = [&](const GridPoint& at) { return static_cast<double>(at.x - frame.low.x); };
  const auto yOf = [&](const GridPoint& at) { return static_cast<double>(at.y - frame.low.y); };
  const double ax = xOf(from), ay = yOf(from), bx = xOf(to), by = yOf(to);
  const double slope = bx > ax ? (by - ay) / (bx - ax) : 0, upright = by != ay ? (bx - ax) / (by - ay) : 0;
  // All that is asked for lies above -size, where this rounds down, as no call of std::floor does at this speed.
  const auto cellAt = [&](double at) { return static_cast<int>(at / size + 1) - 1; };
  const auto columnAt = [&](double at) { return std::clamp(cellAt(at), 0, cells.columns() - 1); };
  const auto firstRow = [&](double low) { return std::max(cellAt(low - beside), band.first); };
  const auto lastRow = [&](double high) { return std::min(cellAt(high + beside), band.last - 1); };
  const auto clearRows = [&](int first, int last, double y, double z) {
    const auto [low, high] = std::minmax(y, z);
    for (int r = firstRow(low), end = lastRow(high); r <= end; ++r) cells.set(r, first, last, false);
  };
  const double lowest = std::min(ay, by), highest = std::max(ay, by);
  if (firstRow(lowest) > lastRow(highest)) return;
  if (std::abs(slope) < 1 && bx > ax) {
    for (int c = columnAt(ax - beside), end = columnAt(bx + beside); c <= end; ++c) {
      const double left = std::clamp(c * size - beside, ax, bx), right = std::clamp((c + 1) * size + beside, ax, bx);
      clearRows(c, c + 1, ay + slope * (left - ax), ay + slope * (right - ax));
    }
    return;
  }
  for (int r = firstRow(lowest), end = lastRow(highest); r <= end; ++r) {
    const auto xAt = [&](double y) { return ax + upright * (std::clamp(y, lowest, highest) - ay); };
    const auto [left, right] = std::minmax({xAt(r * size - beside), xAt((r + 1) * size + beside)});
    cells.set(r, columnAt(left - beside), columnAt(right + beside) + 1, false);
  }
}

/// A place on the middle line of a row where the winding number changes.
struct RowCrossing {
  double x;
  int change;
};

/// Where loops cross the middle lines of the rows of a band, for each row from left to right.
std::vector<std::vector<RowCrossing>> crossingsOf(std::span<const GridPolygon> polygons, const CellFrame& frame,
                                                  const Band& band) {
  std::vector<std::vector<RowCrossing>> crossings(static_cast<std::size_t>(band.last - band.first));
  const double size = std::ldexp(1.0, frame.shift);
  forEachSide(polygons, [&](const GridPoint& p, const GridPoint& q) {
    const int change = p.y < q.y ? -1 : 1;  // the inside lies to the left of a side
    const auto& [low, high] = p.y < q.y ? std::pair{p, q} : std::pair{q, p};
    const double y = static_cast<double>(low.y - frame.low.y), height = static_cast<double>(high.y - low.y);
    const double x = static_cast<double>(low.x - frame.low.x), width = static_cast<double>(high.x - low.x);
    for (int r = std::max(frame.row(low.y) - 1, band.first); r <= std::min(frame.row(high.y) + 1, band.last - 1); ++r) {
      const double middle = (r + 0.5) * size;
      if (middle >= y && middle < y + height)
        crossings[static_cast<std::size_t>(r - band.first)].push_back({(x + (middle - y) / height * width) / size, change});
    }
  });
  for (auto& row : crossings)
    std::sort(row.begin(), row.end(), [](const RowCrossing& a, const RowCrossing& b) { return a.x < b.x; });
  return crossings;
}

void fillBand(std::span<const GridPolygon> polygons, const CellFrame& frame, const Band& band, BitRaster& cells) {
  const auto crossings = crossingsOf(polygons, frame, band);
  for (int r = band.first; r < band.last; ++r) {
    int winding = 0;
    const auto& row = crossings[static_cast<std::size_t>(r - band.first)];
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      winding += row[i].change;
      // Cells with a crossing are cleared below.
      const int end = std::min(static_cast<int>(row[i + 1].x) + 1, cells.columns());
      if (winding > 0) cells.set(r, static_cast<int>(row[i].x), end, true);
    }
  }
  forEachSide(polygons, [&](const GridPoint& p, const GridPoint& q) { clearAlong(p, q, frame, band, cells); });
}

}  // namespace

BitRaster fullCells(std::span<const GridPolygon> polygons, const CellFrame& frame, int columns, int rows) {
  BitRaster cells(columns, rows);
  constexpr std::size_t fewestRows = 256;  // worth a walk along all sides
  parallelFor(static_cast<std::size_t>(rows), fewestRows, Progress::none(), [&](std::size_t first, std::size_t last) {
    fillBand(polygons, frame, {static_cast<int>(first), static_cast<int>(last)}, cells);
  });
  return cells;
}

std::vector<BoundaryCell> boundaryCells(std::span<const GridPolygon> polygons, const CellFrame& frame, double spacing) {
  std::vector<BoundaryCell> cells;
  const double apart = spacing * std::ldexp(1.0, frame.shift);
  forEachSide(polygons, [&](const GridPoint& p, const GridPoint& q) {
    const double width = static_cast<double>(q.x - p.x), height = static_cast<double>(q.y - p.y);
    const double steps = std::ceil(std::max(std::abs(width), std::abs(height)) / apart);
    for (double i = 0; i < std::max(steps, 1.0); ++i) {
      const double share = i / std::max(steps, 1.0);
      cells.push_back({frame.row(p.y + std::llround(share * height)), frame.column(p.x + std::llround(share * width))});
    }
  });
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace blossom::planar
