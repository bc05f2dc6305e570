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
  /// Maximum distance in x from the chord between two heights where x is xa and xb.
  [[nodiscard]] double bulge(double a, double b, double xa, double xb) const;
};

/// A part of a boundary that is monotone in y and, when it is an arc, also in x.
struct Rim {
  double low = 0, high = 0;
  RowCurve curve;

  /// The height at which it has the abscissa x. @pre it has one
  [[nodiscard]] double heightAt(double x) const;
};

/// The area between two heights and two curves; every row crosses it in one interval.
struct Slab {
  double low = 0, high = 0;
  RowCurve left, right;
};

/// Adds the rims of a stroke; a horizontal line has none.
void addRims(const Stroke&, std::vector<Rim>&);
/// The area enclosed by closed boundaries under the even-odd rule, as slabs. The boundaries must not cross. O(n log n + n k)
/// for n rims of which k cross a row.
std::vector<Slab> slabsOf(const std::vector<Rim>&);

/// The area enclosed by closed boundaries, divided in two.
struct SplitRims {
  std::vector<Rim> before, after;  ///< below and above a height, or left and right of a vertical line
};
SplitRims splitAtHeight(const std::vector<Rim>&, double y);
/// Both parts are closed by vertical rims. O(n log n).
SplitRims splitAtLine(const std::vector<Rim>&, double x);

/// The area swept by a disc along a stroke without the discs at its ends, and the area of a disc.
std::vector<Slab> sweptSlabs(const Stroke& way, double radius);
std::vector<Slab> discSlabs(const Vec2& center, double radius);

}  // namespace blossom::pocket
