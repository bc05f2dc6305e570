#pragma once
#include "geometry/planar/polygons/grid.h"

namespace blossom::planar {

inline int signOf(Wide w) { return w > 0 ? 1 : w < 0 ? -1 : 0; }

/// The sign of a b - c d, exactly: in doubles where they tell it, else in 256 bits.
int compareProducts(Wide a, Wide b, Wide c, Wide d);

/// A fraction with a positive denominator, below 2^120 each.
struct Fraction {
  Wide over = 0, under = 1;
};
inline Fraction fraction(Wide over, Wide under) { return under < 0 ? Fraction{-over, -under} : Fraction{over, under}; }
inline int compare(const Fraction& a, const Fraction& b) { return compareProducts(a.over, b.under, b.over, a.under); }

/// Of a point with doubled coordinates beside the line from a to b: 1 to the left, -1 to the right.
inline int sideOf(const GridPoint& a, const GridPoint& b, std::int64_t twiceX, std::int64_t twiceY) {
  return signOf(cross(b - a, GridPoint{twiceX - 2 * a.x, twiceY - 2 * a.y}));
}

/// y - base of the line from a to b, which is not vertical, at twiceX / 2.
inline Fraction heightAt(const GridPoint& a, const GridPoint& b, std::int64_t twiceX, std::int64_t base) {
  const GridPoint along = b - a;
  return fraction(2 * Wide(a.y - base) * along.x + Wide(along.y) * (twiceX - 2 * a.x), 2 * Wide(along.x));
}

}  // namespace blossom::planar
