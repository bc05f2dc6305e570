#pragma once
#include <cstddef>
#include <vector>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// What each pole of a factor contributes to its value at one place: value = sum of share * pole. Poles that contribute
/// nothing are left out. Of a closed motion only the free rows count, those that do not repeat others; where fewer rows are
/// free than basis functions overlap, several functions stand for the same row and add up.
struct PlaceRow {
  std::vector<std::size_t> pole;  ///< increasing indices into `poles`
  std::vector<double> share;      ///< none is 0
  /// The basis functions of a closed motion cancel each other here, up to a millionth: no change of poles reaches the place.
  /// `pole` is empty.
  bool cancelled = false;
};

/// Sign of the rows that repeat the first ones in a factor; 0: the motion is not closed in u.
double closureOfOrientation(const Motion&);
double closureOfScaling(const Motion&);

/// Shares R_j = N_j w_j / sum of N_k w_k of the *Euclidean* poles of the trajectory. O(degree^2).
PlaceRow placeRow(const Curve& trajectory, double v);
/// Shares N_i(u) N_j(v) of the poles of a surface. O(degree^2). @param closure see above
PlaceRow placeRow(const Surface&, const MotionPlace&, double closure);

}  // namespace blossom::sweep
