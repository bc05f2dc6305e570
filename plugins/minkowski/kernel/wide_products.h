#pragma once
#include "kernel/grid.h"

namespace blossom::minkowski {

inline int signOf(Wide w) { return w > 0 ? 1 : w < 0 ? -1 : 0; }

/// The sign of a b - c d, exactly: in doubles where they tell it, else in 256 bits.
int compareProducts(Wide a, Wide b, Wide c, Wide d);

/// A fraction with a positive denominator, below 2^120 each.
struct Fraction {
  Wide over = 0, under = 1;
};
inline Fraction fraction(Wide over, Wide under) { return under < 0 ? Fraction{-over, -under} : Fraction{over, under}; }
inline int compare(const Fraction& a, const Fraction& b) { return compareProducts(a.over, b.under, b.over, a.under); }

}  // namespace blossom::minkowski
