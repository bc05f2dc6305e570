#include "kernel/cubic_spline.h"

namespace blossom::sweep {

namespace {

using Index = Eigen::Index;

/// Slopes from the left and from the right at every break.
struct Slopes {
  Rows left, right;
};

/// Right-hand side of the C2 condition at break i of a run of breaks.
auto balance(const Rows& f, Index before, Index i, Index after, double h0, double h1) {
  return (3 / (h0 * h0)) * (f.row(i) - f.row(before)) + (3 / (h1 * h1)) * (f.row(after) - f.row(i));
}

/// Solves m(i-1)/h(i-1) + 2 m(i) (1/h(i-1) + 1/h(i)) + m(i+1)/h(i) = balance(i) between two breaks with known slopes.
void solveSegment(const std::vector<double>& at, const Rows& f, std::size_t from, std::size_t to, Rows& slope) {
  const auto h = [&](std::size_t i) { return at[i + 1] - at[i]; };
  std::vector<double> upper(to - from, 0.0);
  for (std::size_t i = from + 1; i < to; ++i) {
    const Index row = static_cast<Index>(i);
    const double lower = 1 / h(i - 1), next = 1 / h(i), diagonal = 2 * (lower + next) - lower * upper[i - 1 - from];
    slope.row(row) = (balance(f, row - 1, row, row + 1, h(i - 1), h(i)) - lower * slope.row(row - 1)) / diagonal;
    upper[i - from] = next / diagonal;
  }
  for (std::size_t i = to - 1; i > from; --i)
    slope.row(static_cast<Index>(i)) -= upper[i - from] * slope.row(static_cast<Index>(i) + 1);
}

/// The same around a closed run; the corner entries are taken out by the formula of Sherman and Morrison.
Rows solvePeriodic(const std::vector<double>& at, const Rows& f) {
  const std::size_t n = at.size() - 1;
  const auto h = [&](std::size_t i) { return at[i % n + 1] - at[i % n]; };
  const auto row = [](std::size_t i) { return static_cast<Index>(i); };
  if (n == 1) return Rows::Zero(2, f.cols());
  std::vector<double> diagonal(n), upper(n);
  // One more column: the response to the correction vector.
  Rows right(row(n), f.cols() + 1);
  for (std::size_t i = 0; i < n; ++i) {
    diagonal[i] = 2 * (1 / h(i + n - 1) + 1 / h(i));
    right.row(row(i)).head(f.cols()) = balance(f, row((i + n - 1) % n), row(i), row((i + 1) % n), h(i + n - 1), h(i));
    right(row(i), f.cols()) = 0;
  }
  if (n == 2) {  // both neighbours are the same break
    Rows m(3, f.cols());
    const double a = diagonal[0], b = 1 / h(1) + 1 / h(0), determinant = a * diagonal[1] - b * b;
    m.row(0) = (diagonal[1] * right.row(0).head(f.cols()) - b * right.row(1).head(f.cols())) / determinant;
    m.row(1) = (a * right.row(1).head(f.cols()) - b * right.row(0).head(f.cols())) / determinant;
    m.row(2) = m.row(0);
    return m;
  }
  const double corner = 1 / h(n - 1), gamma = -diagonal[0];
  diagonal[0] -= gamma;
  diagonal[n - 1] -= corner * corner / gamma;
  right(0, f.cols()) = gamma;
  right(row(n - 1), f.cols()) = corner;
  for (std::size_t i = 0; i < n; ++i) {
    const double lower = i > 0 ? 1 / h(i - 1) : 0, pivot = diagonal[i] - (i > 0 ? lower * upper[i - 1] : 0);
    if (i > 0) right.row(row(i)) -= lower * right.row(row(i - 1));
    right.row(row(i)) /= pivot;
    upper[i] = 1 / h(i) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) right.row(row(i)) -= upper[i] * right.row(row(i + 1));
  const auto z = right.col(f.cols());
  const double bottom = 1 + z(0) + corner / gamma * z(row(n - 1));
  const Eigen::RowVectorXd share = (right.row(0) + corner / gamma * right.row(row(n - 1))).head(f.cols()) / bottom;
  Rows m(row(n) + 1, f.cols());
  m.topRows(row(n)) = right.leftCols(f.cols()) - z * share;
  m.row(row(n)) = m.row(0);
  return m;
}

Slopes solve(const CubicBreaks& breaks, const Rows& values, const Rows& slopes) {
  if (breaks.periodic) {
    const Rows m = solvePeriodic(breaks.at, values);
    return {m, m};
  }
  Slopes result{Rows(values.rows(), values.cols()), Rows(values.rows(), values.cols())};
  Rows m(values.rows(), values.cols());
  Index k = 0;
  for (const auto& [from, to] : breaks.segments()) {
    const Index first = static_cast<Index>(from), last = static_cast<Index>(to);
    m.row(first) = slopes.row(k), m.row(last) = slopes.row(k + 1);
    k += 2;
    solveSegment(breaks.at, values, from, to, m);
    result.right.middleRows(first, last - first) = m.middleRows(first, last - first);
    result.left.middleRows(first + 1, last - first) = m.middleRows(first + 1, last - first);
  }
  return result;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> CubicBreaks::segments() const {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  if (periodic) return result;
  std::size_t from = 0;
  for (std::size_t i = 1; i < at.size(); ++i)
    if (i + 1 == at.size() || multiplicity[i] > 1) {
      result.emplace_back(from, i);
      from = i;
    }
  return result;
}

std::vector<double> CubicBreaks::knots() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < at.size(); ++i)
    result.insert(result.end(), i == 0 || i + 1 == at.size() ? 4 : static_cast<std::size_t>(multiplicity[i]), at[i]);
  return result;
}

Rows interpolateCubic(const CubicBreaks& breaks, const Rows& values, const Rows& slopes) {
  const Slopes m = solve(breaks, values, slopes);
  // Break of every knot; a pole is the blossom of a piece at three knots in a row, written here with Hermite data.
  std::vector<Index> owner;
  for (std::size_t i = 0; i < breaks.at.size(); ++i)
    owner.insert(owner.end(), i == 0 || i + 1 == breaks.at.size() ? 3 : static_cast<std::size_t>(breaks.multiplicity[i]),
                 static_cast<Index>(i));
  const auto at = [&](Index i) { return breaks.at[static_cast<std::size_t>(i)]; };
  Rows poles(static_cast<Index>(owner.size()) - 2, values.cols());
  for (std::size_t i = 0; i + 2 < owner.size(); ++i) {
    const Index x = owner[i], y = owner[i + 1], z = owner[i + 2], out = static_cast<Index>(i);
    if (x == z) {
      poles.row(out) = values.row(y);
    } else if (x == y) {
      poles.row(out) = values.row(y) + (at(z) - at(y)) / 3 * m.right.row(y);
    } else if (y == z) {
      poles.row(out) = values.row(y) - (at(y) - at(x)) / 3 * m.left.row(y);
    } else {
      const double h = at(y) - at(x), ratio = (at(z) - at(x)) / h;
      poles.row(out) =
          (1 - ratio) * (values.row(x) + h / 3 * m.right.row(x)) + ratio * (values.row(y) - h / 3 * m.left.row(y));
    }
  }
  return poles;
}

}  // namespace blossom::sweep
