#include "geometry/planar/winding/anchored_edge.h"

namespace blossom::planar {

namespace {

/// Whether an edge that crosses the level of the corner does so beyond x, just below that level.
bool beyond(const CountedEdge& d, std::int64_t twiceX, std::int64_t twiceY) {
  const bool up = d.to.y > d.from.y;
  const int side = sideOf(d.from, d.to, twiceX, twiceY);
  if (side == 0) return !up;
  return (side > 0) == up;  // the point is to the left of an edge that goes up
}

}  // namespace

Anchor AnchoredEdge::at(bool vertical, std::int64_t twice, const Cell& corner) const {
  const std::int64_t from = vertical ? edge_.from.x : edge_.from.y, along = vertical ? by_.x : by_.y;
  return {vertical, twice, corner.column, corner.row, fraction(Wide(twice - 2 * from), 2 * Wide(along))};
}

Anchor AnchoredEdge::atStart(const Cell& first) const {
  if (by_.x >= std::abs(by_.y)) return at(true, 2 * edge_.from.x + 1, first);
  return at(false, 2 * edge_.from.y + (by_.y > 0 ? 1 : -1), first);
}

Anchor AnchoredEdge::between(const Cell& from, const Cell& to) const {
  if (from.column != to.column) return at(true, cells_.borderX(to.column), to);
  if (to.row > from.row) return at(false, cells_.borderY(to.row), to);
  return at(false, cells_.borderY(from.row), {to.column, from.row});
}

int AnchoredEdge::windingToLeft(const Anchor& anchor, const Cell& cell, int covering) const {
  int winding = cells_.windingBelow(anchor.column, anchor.row);
  for (const std::uint32_t k : cells_.edgesNear(cell))
    if (k != number_) winding += anchor.vertical ? passedGoingUp(edges_[k], anchor) : passedGoingRight(edges_[k], anchor);
  // The way came from the right of an edge that runs right or down.
  return anchor.vertical || by_.y < 0 ? winding + covering : winding;
}

/// Along the border below the cell to x = value, then up to the edge.
int AnchoredEdge::passedGoingUp(const CountedEdge& d, const Anchor& anchor) const {
  const std::int64_t x0 = cells_.borderX(anchor.column), y0 = cells_.borderY(anchor.row), value = anchor.twice;
  const GridPoint along = d.to - d.from;
  int winding = 0;
  if (value != x0 && (2 * d.from.y < y0) != (2 * d.to.y < y0) && beyond(d, x0, y0) && !beyond(d, value, y0))
    winding += along.y > 0 ? -d.count : d.count;
  if (2 * d.from.x < value && 2 * d.to.x > value && sideOf(d.from, d.to, value, y0) <= 0) {
    int order = compare(heightOf(d, value), heightOf(edge_, value));
    if (order == 0) order = signOf(cross(by_, along));
    if (order < 0) winding += d.count;
  }
  return winding;
}

/// Up along the border left of the cell to y = value, then right to the edge; just beyond the value, where the edge goes.
int AnchoredEdge::passedGoingRight(const CountedEdge& d, const Anchor& anchor) const {
  const std::int64_t x0 = cells_.borderX(anchor.column), y0 = cells_.borderY(anchor.row), value = anchor.twice;
  const GridPoint along = d.to - d.from;
  const bool up = by_.y > 0;
  int winding = 0;
  if (2 * d.from.x < x0 && 2 * d.to.x > x0 && sideOf(d.from, d.to, x0, y0) <= 0) {
    const int side = sideOf(d.from, d.to, x0, value);  // of the end of the way; d runs to the right
    if (side > 0 || (side == 0 && up)) winding += d.count;
  }
  if ((2 * d.from.y < value) != (2 * d.to.y < value)) {
    const int corner = sideOf(d.from, d.to, x0, value);
    const bool right = corner == 0 ? up == (along.y > 0) : (corner > 0) == (along.y > 0);
    if (right) {
      int order = compare(reachOf(d, value), reachOf(edge_, value));
      if (order == 0) order = signOf(cross(along, by_)) * (along.y > 0 ? 1 : -1);
      // cross / (dy cy) has the sign of the difference of dx/dy, and one turns with the way of the edge
      if (order < 0) winding += along.y > 0 ? -d.count : d.count;
    }
  }
  return winding;
}

/// y where an edge that is not vertical has this x, from the start of the walked edge on.
Fraction AnchoredEdge::heightOf(const CountedEdge& d, std::int64_t twiceX) const {
  return heightAt(d.from, d.to, twiceX, edge_.from.y);
}
/// x where an edge that is not level has this y, from the start of the walked edge on.
Fraction AnchoredEdge::reachOf(const CountedEdge& d, std::int64_t twiceY) const {
  const auto turned = [](const GridPoint& p) { return GridPoint{p.y, p.x}; };
  return heightAt(turned(d.from), turned(d.to), twiceY, edge_.from.x);
}

}  // namespace blossom::planar
