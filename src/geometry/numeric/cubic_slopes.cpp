#include "geometry/numeric/cubic_slopes.h"

#include <vector>

namespace blossom {

namespace {

using Index = Eigen::Index;

/// Right-hand side of the condition on the second derivative at row i, h0 from row `before` and h1 from row `after`.
auto balance(const Eigen::Ref<const NumberRows>& f, Index before, Index i, Index after, double h0, double h1) {
  return (3 / h0) * ((f.row(i) - f.row(before)) / h0) + (3 / h1) * ((f.row(after) - f.row(i)) / h1);
}

/// Rows lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = right[i], diagonally dominant (Thomas's algorithm).
struct Tridiagonal {
  std::vector<double> lower, diagonal, upper;

  explicit Tridiagonal(std::size_t n) : lower(n, 0), diagonal(n, 1), upper(n, 0) {}

  /// Turns right-hand sides into solutions.
  void solve(NumberRows& right) {
    const auto row = [&](std::size_t i) { return right.row(static_cast<Index>(i)); };
    const std::size_t n = diagonal.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double pivot = diagonal[i] - (i > 0 ? lower[i] * upper[i - 1] : 0);
      if (i > 0 && lower[i] != 0) row(i) -= lower[i] * row(i - 1);
      row(i) /= pivot;
      upper[i] /= pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) row(i) -= upper[i] * row(i + 1);
  }
};

}  // namespace

NumberRows cubicSlopes(std::span<const double> h, const Eigen::Ref<const NumberRows>& values,
                       const std::optional<Eigen::RowVectorXd>& start, const std::optional<Eigen::RowVectorXd>& end) {
  const std::size_t n = h.size() + 1;
  const auto last = static_cast<Index>(n) - 1;
  Tridiagonal system(n);
  NumberRows right(last + 1, values.cols());
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const auto i = static_cast<Index>(k);
    system.lower[k] = 1 / h[k - 1];
    system.upper[k] = 1 / h[k];
    system.diagonal[k] = 2 * (system.lower[k] + system.upper[k]);
    right.row(i) = balance(values, i - 1, i, i + 1, h[k - 1], h[k]);
  }
  if (start) {
    right.row(0) = *start;
  } else {
    system.diagonal[0] = 2, system.upper[0] = 1;
    right.row(0) = 3 / h[0] * (values.row(1) - values.row(0));
  }
  if (end) {
    right.row(last) = *end;
  } else {
    system.diagonal[n - 1] = 2, system.lower[n - 1] = 1;
    right.row(last) = 3 / h[n - 2] * (values.row(last) - values.row(last - 1));
  }
  system.solve(right);
  return right;
}

NumberRows periodicCubicSlopes(std::span<const double> h, const Eigen::Ref<const NumberRows>& values) {
  const std::size_t n = h.size();
  const Index last = static_cast<Index>(n) - 1, columns = values.cols();
  if (n == 1) return NumberRows::Zero(1, columns);
  Tridiagonal system(n);
  NumberRows right(last + 1, columns + 1);  // the last column: the response to the correction of the corners
  right.col(columns).setZero();
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<Index>(k);
    const double before = h[(k + n - 1) % n];
    system.lower[k] = 1 / before;
    system.upper[k] = 1 / h[k];
    system.diagonal[k] = 2 * (system.lower[k] + system.upper[k]);
    right.row(i).head(columns) = balance(values, i > 0 ? i - 1 : last, i, i < last ? i + 1 : 0, before, h[k]);
  }
  if (n == 2) {  // both neighbours are the same place
    const double a = system.diagonal[0], b = system.lower[0] + system.upper[0], determinant = a * a - b * b;
    NumberRows slopes(2, columns);
    slopes.row(0) = (a * right.row(0).head(columns) - b * right.row(1).head(columns)) / determinant;
    slopes.row(1) = (a * right.row(1).head(columns) - b * right.row(0).head(columns)) / determinant;
    return slopes;
  }
  // The corner entries are a matrix of rank one, taken out by the formula of Sherman and Morrison.
  const double corner = system.lower[0], gamma = -system.diagonal[0], ratio = corner / gamma;
  system.lower[0] = system.upper[n - 1] = 0;
  system.diagonal[0] -= gamma;
  system.diagonal[n - 1] -= corner * ratio;
  right(0, columns) = gamma;
  right(last, columns) = corner;
  system.solve(right);
  const auto response = right.col(columns);
  const Eigen::RowVectorXd share =
      (right.row(0) + ratio * right.row(last)).head(columns) / (1 + response(0) + ratio * response(last));
  return right.leftCols(columns) - response * share;
}

}  // namespace blossom
