#include "kernel/begin/motion_knots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

using Knots = std::vector<double>;

/// Whether the knots may be inserted into a factor with `own`, of which those at the ends do not count.
void requireInsertable(const Knots& wanted, int degree, const Knots& own, std::pair<double, double> domain,
                       const char* direction) {
  for (const double knot : wanted) {
    if (!(knot >= domain.first && knot <= domain.second))
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("The knot {} = {} lies outside the motion, which runs from {} to {}.", direction, knot,
                              domain.first, domain.second),
                  "Give a knot inside the motion.");
    const auto there = std::count(own.begin(), own.end(), knot), more = std::count(wanted.begin(), wanted.end(), knot);
    if (there > degree)
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("{} = {} is an end of the motion, where no knot can be added.", direction, knot),
                  fmt::format("Give a knot between {} and {}.", domain.first, domain.second));
    if (there + more > degree)
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("The knot {} = {} would stand {} times; at most {} are possible.", direction, knot,
                              there + more, degree),
                  "Insert it fewer times, or another one beside it.");
  }
}

Surface withOpenKnotsU(const Surface& factor, const Knots& knots) {
  requireInsertable(knots, factor.degreeU, factor.knotsU, factor.domainU(), "u");
  return insertKnotsU(factor, knots);
}

Surface withKnotsV(const Surface& factor, const Knots& knots) {
  requireInsertable(knots, factor.degreeV, factor.knotsV, factor.domainV(), "v");
  return insertKnotsV(factor, knots);
}

/// The knots of one period, u0 to un.
Knots periodOf(const Surface& factor) {
  const auto first = factor.knotsU.begin() + factor.degreeU;
  return {first, first + static_cast<std::ptrdiff_t>(factor.countU()) - factor.degreeU + 1};
}

/// Places of a knot of one period in a run of periods, `copies` of them on each side.
class PeriodShift {
 public:
  PeriodShift(const Knots& period, std::size_t copies)
      : first_(period.front()), last_(period.back()), copies_(static_cast<double>(copies)) {}

  /// The knots of the middle copy stay exact, and so do the ends of its neighbours.
  [[nodiscard]] double operator()(double knot, std::size_t copy) const {
    const double shift = static_cast<double>(copy) - copies_;
    if (shift == 0) return knot;
    if (shift == -1 && knot == last_) return first_;
    if (shift == 1 && knot == first_) return last_;
    return knot + shift * (last_ - first_);
  }

 private:
  double first_, last_, copies_;
};

/// A run of an odd number of periods of a closed factor, as a closed one.
Surface unrolled(const Surface& factor, const Knots& period, std::size_t copies, double sign) {
  const std::size_t n = period.size() - 1;
  const PeriodShift shifted(period, copies);
  Knots all;
  std::vector<Vec4> poles;
  for (std::size_t copy = 0; copy <= 2 * copies; ++copy) {
    for (std::size_t i = 0; i < n; ++i) all.push_back(shifted(period[i], copy));
    const double signOfCopy = sign < 0 && (copy + copies) % 2 == 1 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < n * factor.countV(); ++k) poles.push_back(signOfCopy * factor.poles[k]);
  }
  all.push_back(shifted(period.back(), 2 * copies));
  return unwrapped(factor.degreeU, factor.degreeV, all, factor.knotsV, std::move(poles), sign);
}

Surface withClosedKnotsU(const Surface& factor, const Knots& wanted, double sign) {
  const Knots period = periodOf(factor);
  const double first = period.front(), last = period.back();
  // The end is the start.
  const auto fromStart = [&](Knots knots) {
    std::replace(knots.begin(), knots.end(), last, first);
    return knots;
  };
  const Knots knots = fromStart(wanted);
  requireInsertable(knots, factor.degreeU, fromStart({period.begin(), period.end() - 1}), {first, last}, "u");

  const std::size_t n = period.size() - 1, copies = static_cast<std::size_t>(factor.degreeU) / n + 2;
  const PeriodShift shifted(period, copies);
  const Surface run = unrolled(factor, period, copies, sign);
  Knots everywhere;
  for (std::size_t copy = 0; copy <= 2 * copies; ++copy)
    for (const double knot : knots) everywhere.push_back(shifted(knot, copy));
  std::sort(everywhere.begin(), everywhere.end());
  const Surface fine = insertKnotsU(run, everywhere);

  // The first knot of the period is the last of those equal to it that belong before the domain.
  const auto before = std::count(period.begin(), period.end() - 1, last);
  const auto start = std::lower_bound(fine.knotsU.begin(), fine.knotsU.end(), first) + before;
  const std::size_t rows = n + knots.size();
  Knots newPeriod(start, start + static_cast<std::ptrdiff_t>(rows) + 1);
  const std::size_t row = static_cast<std::size_t>(start - fine.knotsU.begin()) - static_cast<std::size_t>(factor.degreeU);
  const auto poles = fine.poles.begin() + static_cast<std::ptrdiff_t>(row * fine.countV());
  return unwrapped(factor.degreeU, factor.degreeV, newPeriod, factor.knotsV,
                   {poles, poles + static_cast<std::ptrdiff_t>(rows * fine.countV())}, sign);
}

/// The base with more knots, those at the ends of the domain not among them.
Knots grown(Knots base, const Knots& wanted, std::pair<double, double> domain) {
  for (const double knot : wanted)
    if (knot > domain.first && knot < domain.second) base.push_back(knot);
  std::sort(base.begin(), base.end());
  return base;
}

BaseKnots grown(const Motion& motion, const MotionKnots& wanted) {
  BaseKnots base = *motion.base;
  if (wanted.trajectory) base.trajectory = grown(base.trajectory, wanted.v, motion.domainV());
  const auto grow = [&](std::array<Knots, 2>& factor) {
    factor = {grown(factor[0], wanted.u, motion.domainU()), grown(factor[1], wanted.v, motion.domainV())};
  };
  if (wanted.orientation) grow(base.orientation);
  if (wanted.scaling) grow(base.scaling);
  return base;
}

}  // namespace

Motion withKnots(const Motion& motion, const MotionKnots& wanted) {
  Knots u = wanted.u, v = wanted.v;
  std::sort(u.begin(), u.end());
  std::sort(v.begin(), v.end());
  Motion result = motion;
  if (wanted.trajectory) {
    requireInsertable(v, motion.trajectory.degree, motion.trajectory.knots, motion.domainV(), "v");
    result.trajectory = insertKnots(motion.trajectory, v);
  }
  const auto refine = [&](Surface& factor, double sign) {
    factor = motion.closedU == ClosedU::No ? withOpenKnotsU(factor, u) : withClosedKnotsU(factor, u, sign);
    factor = withKnotsV(factor, v);
  };
  if (wanted.orientation) refine(result.orientation, motion.closedU == ClosedU::AntiPeriodic ? -1 : 1);
  if (wanted.scaling) refine(result.scaling, 1);
  if (motion.base) result.base = grown(motion, wanted);
  return result;
}

}  // namespace blossom::sweep
