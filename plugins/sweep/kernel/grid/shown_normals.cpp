#include "kernel/grid/shown_normals.h"

namespace blossom::sweep {

namespace {

bool lacksNormal(const MotionGrid& grid, const GridRange& rows, std::size_t column) {
  for (std::size_t k = rows.begin; k < rows.end; ++k)
    if (grid.normalAt(k, column).isZero(0)) return true;
  return false;
}

}  // namespace

Vec3 shownNormal(const MotionGrid& grid, std::size_t k, std::size_t l) {
  Vec3 normal = grid.normalAt(k, l);
  for (std::size_t step = 1; normal.isZero(0) && step < grid.countV; ++step) {
    if (l + step < grid.countV) normal = grid.normalAt(k, l + step);
    if (normal.isZero(0) && l >= step) normal = grid.normalAt(k, l - step);
  }
  return normal;
}

GridRectangle withBorrowers(const MotionGrid& grid, GridRectangle part) {
  while (part.columns.begin > 0 && lacksNormal(grid, part.rows, part.columns.begin - 1)) --part.columns.begin;
  while (part.columns.end < grid.countV && lacksNormal(grid, part.rows, part.columns.end)) ++part.columns.end;
  return part;
}

}  // namespace blossom::sweep
