#pragma once
#include <cstddef>
#include <vector>

namespace blossom::sweep {

/// A closed cubic function of one parameter over the period 0..1 through given values.
struct PeriodicBreaks {
  std::vector<double> at;    ///< increasing, 0 first, all below 1
  std::vector<bool> corner;  ///< one for each: the slope may jump there; not at 0

  [[nodiscard]] bool smooth() const;
  /// 0..1 as `unwrapped` takes it: corners three times.
  [[nodiscard]] std::vector<double> period() const;
};

/// Values and one-sided slopes at the breaks; slopes are used at corners only.
struct PeriodicValues {
  std::vector<double> value, slopeLeft, slopeRight;
};

/// Poles over breaks.period(), one for each knot but the last: C2 but at the corners, where the slopes given are met.
/// O(breaks).
std::vector<double> interpolatePeriodic(const PeriodicBreaks&, const PeriodicValues&);

}  // namespace blossom::sweep
