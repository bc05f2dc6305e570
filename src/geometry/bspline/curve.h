#pragma once
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom {

/// A B-spline curve of any degree with values in R^4, read projectively: a pole (w x, w y, w z, w) stands for the point
/// (x, y, z) with weight w. The four components are also used as they are, e.g. for quaternions.
///
/// The knot vector is full: knots.size() == poles.size() + degree + 1, non-decreasing, clamped or not. The domain is
/// [knots[degree], knots[poles.size()]].
struct Curve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<Vec4> poles;

  [[nodiscard]] std::pair<double, double> domain() const {
    return {knots[static_cast<std::size_t>(degree)], knots[poles.size()]};
  }
  friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace blossom
