#include "kernel/begin/periodic_cubic.h"

#include <algorithm>

#include "geometry/numeric/cubic_slopes.h"

namespace blossom::sweep {

namespace {

/// The step from break k to the next, around the end.
double stepAfter(const PeriodicBreaks& breaks, std::size_t k) {
  return k + 1 < breaks.at.size() ? breaks.at[k + 1] - breaks.at[k] : 1 - breaks.at[k] + breaks.at[0];
}

/// Slopes of the C2 pieces between corners; at corners those given stay.
void solveSlopes(const PeriodicBreaks& breaks, PeriodicValues& values) {
  const std::size_t n = breaks.at.size();
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < n; ++k)
    if (breaks.corner[k]) corners.push_back(k);
  for (std::size_t c = 0; c < std::max<std::size_t>(corners.size(), 1); ++c) {
    const std::size_t from = corners.empty() ? 0 : corners[c],
                      to = corners.empty() ? n - 1 : corners[(c + 1) % corners.size()] + (c + 1 == corners.size() ? n : 0);
    std::vector<double> steps;
    NumberRows rows(static_cast<Eigen::Index>(to - from + 1), 1);
    for (std::size_t k = from; k <= to; ++k) {
      rows(static_cast<Eigen::Index>(k - from), 0) = values.value[k % n];
      if (k < to || corners.empty()) steps.push_back(stepAfter(breaks, k % n));
    }
    const auto end = [](double slope) { return Eigen::RowVectorXd::Constant(1, slope).eval(); };
    const NumberRows slopes = corners.empty()
                                  ? periodicCubicSlopes(steps, rows)
                                  : cubicSlopes(steps, rows, end(values.slopeRight[from]), end(values.slopeLeft[to % n]));
    for (std::size_t k = from; k <= to; ++k)
      if (!breaks.corner[k % n])
        values.slopeLeft[k % n] = values.slopeRight[k % n] = slopes(static_cast<Eigen::Index>(k - from), 0);
  }
}

}  // namespace

bool PeriodicBreaks::smooth() const { return std::find(corner.begin(), corner.end(), true) == corner.end(); }

std::vector<double> PeriodicBreaks::period() const {
  std::vector<double> result;
  for (std::size_t k = 0; k < at.size(); ++k) result.insert(result.end(), corner[k] ? 3 : 1, at[k]);
  result.push_back(1);
  return result;
}

std::vector<double> interpolatePeriodic(const PeriodicBreaks& breaks, const PeriodicValues& given) {
  PeriodicValues values = given;
  solveSlopes(breaks, values);
  std::vector<std::size_t> owner;  // break of each knot of one period
  for (std::size_t k = 0; k < breaks.at.size(); ++k) owner.insert(owner.end(), breaks.corner[k] ? 3 : 1, k);
  const std::size_t n = owner.size();
  std::vector<double> poles(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Pole i stands over the knots i - 2, i - 1 and i: the first knots of the unwrapped vector lie before the period.
    const std::size_t x = owner[(i + 2 * n - 2) % n], y = owner[(i + 2 * n - 1) % n], z = owner[i];
    const double before = stepAfter(breaks, x), after = stepAfter(breaks, y);
    if (x == y && y == z && breaks.corner[x]) {
      poles[i] = values.value[y];
    } else if (x == y) {
      poles[i] = values.value[y] + after / 3 * values.slopeRight[y];
    } else if (y == z) {
      poles[i] = values.value[y] - before / 3 * values.slopeLeft[y];
    } else {
      const double ratio = (before + after) / before;
      poles[i] = (1 - ratio) * (values.value[x] + before / 3 * values.slopeRight[x]) +
                 ratio * (values.value[y] - before / 3 * values.slopeLeft[y]);
    }
  }
  return poles;
}

}  // namespace blossom::sweep
