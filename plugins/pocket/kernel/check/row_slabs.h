#pragma once
#include <vector>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// x as a function of y: a straight line, or the left or right half of a circle.
struct RowCurve {
  Vec2 through = Vec2::Zero();  ///< of a line: one of its points; of a circle: its centre
  double slope = 0;             ///< of a line: dx / dy
  double radius = 0;            ///< of a circle; 0: a line
  double side = 1;              ///< of a circle: +1 its right half, -1 its left one

  [[nodiscard]] double at(double y) const;
  /// Most that x is off the chord between two heights where it is xa and xb.
  [[nodiscard]] double bulge(double a, double b, double xa, double xb) const;
};

/// A piece of a boundary that rises or falls throughout and, when it is round, does not change its direction in x.
struct Rim {
  double low = 0, high = 0;
  RowCurve curve;

  /// The height where it is at x, which it must reach.
  [[nodiscard]] double heightAt(double x) const;
};

/// What lies between two heights and two curves: every row crosses it in one interval.
struct Slab {
  double low = 0, high = 0;
  RowCurve left, right;
};

/// The rims of a stroke; one that runs level has none.
void addRims(const Stroke&, std::vector<Rim>&);
/// The area that closed boundaries enclose by the even-odd rule, in slabs. The boundaries must not cross.
/// O(n log n + n k) for n rims of which k cross a row.
std::vector<Slab> slabsOf(const std::vector<Rim>&);

/// The area that closed boundaries enclose, cut in two.
struct SplitRims {
  std::vector<Rim> before, after;  ///< below and above a height, or left and right of an upright line
};
SplitRims splitAtHeight(const std::vector<Rim>&, double y);
/// Upright rims close both parts. O(n log n).
SplitRims splitAtLine(const std::vector<Rim>&, double x);

/// What a disc sweeps along a stroke without the discs at its ends, and a disc alone.
std::vector<Slab> sweptSlabs(const Stroke& way, double radius);
std::vector<Slab> discSlabs(const Vec2& center, double radius);

}  // namespace blossom::pocket
