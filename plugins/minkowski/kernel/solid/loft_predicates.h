#pragma once
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/solid/loft_facets.h"

// Only files of this folder include this one: the wide integers take a while to compile.
namespace blossom::minkowski {

using Wide512 = boost::multiprecision::int512_t;

/// A height, exactly: the weights `first` and `second` of the two sets, of at most 290 bits, with a positive sum.
struct LoftTime {
  Wide512 first = 1, second = 0;
  double t = 0;  ///< rounded
};
LoftTime timeOf(const LoftLevel&);
/// Of a double in 0..1, to 60 bits.
LoftTime timeOf(double t);
LoftTime timeOf(Wide512 first, Wide512 second);
/// -1 when a is lower than b.
int compare(const LoftTime& a, const LoftTime& b);
/// A height between two others, however close they are.
LoftTime between(const LoftTime& a, const LoftTime& b);

/// A function of t, linear from `at[0]` at the bottom to `at[1]` at the top, with bounds of the rounding.
struct LoftRamp {
  std::array<double, 2> at{}, error{};
  [[nodiscard]] double value(double t) const { return (1 - t) * at[0] + t * at[1]; }
  [[nodiscard]] double bound() const { return 2 * (error[0] + error[1]) + 4e-16 * (std::abs(at[0]) + std::abs(at[1])); }
  /// 1 or -1 when that is certain at this t, else 0.
  [[nodiscard]] int signAt(double t, double slack = 0) const {
    const double v = value(t), b = bound() + slack * std::abs(at[1] - at[0]);
    return v > b ? 1 : v < -b ? -1 : 0;
  }
};

/// Exact answers about facets, by doubles where these are certain and by integers of 512 bits elsewhere. Facets are named by
/// their numbers; the line of a facet is that of its edge at a height.
class LoftPredicates {
 public:
  explicit LoftPredicates(std::span<const LoftFacet>);

  /// The sign of cross(direction of i, direction of j).
  [[nodiscard]] int turn(int i, int j) const;
  /// 1 when an end (0: from, 1: to) of facet k lies to the left of the line of facet i, 0 when on it.
  [[nodiscard]] int side(int i, int k, int end, const LoftTime& time) const {
    const Rounded &line = rounded_[static_cast<std::size_t>(i)], &f = rounded_[static_cast<std::size_t>(k)];
    const auto at = [s = 1 - time.t, t = time.t](const double* ends) { return s * ends[0] + t * ends[1]; };
    const double v =
        line.alongX * at(end == 0 ? f.fromY : f.toY) - line.alongY * at(end == 0 ? f.fromX : f.toX) - at(line.offset);
    return v > line.bound ? 1 : v < -line.bound ? -1 : closeSide(i, k, end, time);
  }
  /// The same for where the lines of i and j meet and the line of k. @pre i and j are not parallel
  [[nodiscard]] int sideOfMeeting(int i, int j, int k, const LoftTime&) const;
  /// The sign of how far an end of k lies beyond an end of m in the direction of i.
  [[nodiscard]] int ahead(int i, int k, int endOfK, int m, int endOfM, const LoftTime&) const;

  /// What `side` and `sideOfMeeting` (times `turn(i, j)`) tell the sign of, and for parallel facets the distance of the
  /// lines.
  [[nodiscard]] LoftRamp sideRamp(int i, int k, int end) const;
  [[nodiscard]] LoftRamp meetingRamp(int i, int j, int k) const;
  [[nodiscard]] LoftRamp distanceRamp(int i, int j) const;
  using ExactRamp = std::array<Wide512, 2>;
  [[nodiscard]] ExactRamp exactSide(int i, int k, int end) const;
  [[nodiscard]] ExactRamp exactMeeting(int i, int j, int k) const;
  [[nodiscard]] ExactRamp exactDistance(int i, int j) const;

  /// A point in units of 2^-12 of the grid and its height in units of 2^-60, rounded down from the exact value: equal points
  /// are equal here, however they are made.
  using Place = std::array<std::int64_t, 3>;
  [[nodiscard]] Place placeOfMeeting(int i, int j, const LoftTime&) const;
  [[nodiscard]] Place placeOfEnd(int k, int end, const LoftTime&) const;

 private:
  struct Rounded {
    double alongX, alongY, offset[2], fromX[2], fromY[2], toX[2], toY[2];
    double bound;  ///< of the rounding of `side`, wherever the other facet is
  };
  [[nodiscard]] int closeSide(int i, int k, int end, const LoftTime&) const;
  [[nodiscard]] Wide512 offsetAt(int i, const LoftTime&) const;

  std::span<const LoftFacet> facets_;
  std::vector<Rounded> rounded_;
};

}  // namespace blossom::minkowski
