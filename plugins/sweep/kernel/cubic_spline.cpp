#include "kernel/cubic_spline.h"

namespace blossom::sweep {

namespace {

using Index = Eigen::Index;

/// Slopes from the left and from the right at every break.
struct Slopes {
  Rows left, right;
};

Slopes solve(const CubicBreaks& breaks, const Rows& values, const Rows& slopes) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < breaks.at.size(); ++i) steps.push_back(breaks.at[i + 1] - breaks.at[i]);
  if (breaks.periodic) {
    Rows m(values.rows(), values.cols());
    m.topRows(values.rows() - 1) = periodicCubicSlopes(steps, values);
    m.row(values.rows() - 1) = m.row(0);
    return {m, m};
  }
  Slopes result{Rows(values.rows(), values.cols()), Rows(values.rows(), values.cols())};
  Index k = 0;
  for (const auto& [from, to] : breaks.segments()) {
    const Index first = static_cast<Index>(from), last = static_cast<Index>(to);
    const Rows m = cubicSlopes(std::span(steps).subspan(from, to - from), values.middleRows(first, last - first + 1),
                               slopes.row(k), slopes.row(k + 1));
    k += 2;
    result.right.middleRows(first, last - first) = m.topRows(last - first);
    result.left.middleRows(first + 1, last - first) = m.bottomRows(last - first);
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
