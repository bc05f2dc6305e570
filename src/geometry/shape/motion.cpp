#include "geometry/shape/motion.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom {

namespace {

[[noreturn]] void fail(const char* factor, const std::string& problem) {
  throw Error(ErrorCode::InvalidInput, fmt::format("The {} of this motion cannot be used: {}", factor, problem));
}

template <class Spline>
void validateFactor(const char* factor, const Spline& spline) {
  try {
    validate(spline);
  } catch (const Error& error) {
    fail(factor, error.message());
  }
}

void requireSameDomain(const char* factor, const char* direction, std::pair<double, double> domain,
                       std::pair<double, double> wanted) {
  if (domain != wanted)
    fail(factor, fmt::format("its domain in {} is {} to {}, that of the orientation {} to {}.", direction, domain.first,
                             domain.second, wanted.first, wanted.second));
}

void requireContinuity(const char* factor, int degree, const std::vector<double>& knots) {
  const std::size_t last = knots.size() - 1 - static_cast<std::size_t>(degree);
  const double first = knots[static_cast<std::size_t>(degree)], end = knots[last];
  for (std::size_t i = 0; i + static_cast<std::size_t>(degree) < knots.size(); ++i)
    if (knots[i] > first && knots[i] < end && knots[i] == knots[i + static_cast<std::size_t>(degree)])
      fail(factor, fmt::format("it tears apart at the knot {}, which has a multiplicity above the degree.", knots[i]));
}

/// Knots at the seam count on both of its sides: inside the domain they stand nowhere.
void requireContinuousSeam(const char* factor, const Surface& surface) {
  const std::vector<double>& knots = surface.knotsU;
  const auto degree = static_cast<std::ptrdiff_t>(surface.degreeU);
  const int multiplicity = seamMultiplicity({knots.begin() + degree, knots.end() - degree});
  if (multiplicity > surface.degreeU)
    fail(factor, fmt::format("it tears apart at its seam u = {}, whose knot has a multiplicity of {}, above the degree.",
                             surface.domainU().first, multiplicity));
}

void requireClosed(const char* factor, const Surface& surface, double sign) {
  const std::size_t degree = static_cast<std::size_t>(surface.degreeU), period = surface.countU() - degree;
  const auto [first, last] = surface.domainU();
  for (std::size_t i = 0; i + period < surface.knotsU.size(); ++i)
    if (std::abs(surface.knotsU[i + period] - surface.knotsU[i] - (last - first)) > 1e-12 * (last - first))
      fail(factor, "it is to be closed in u, but its knots do not repeat after one period.");
  for (std::size_t i = 0; i < degree; ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j)
      if (surface.pole(i + period, j) != sign * surface.pole(i, j))
        fail(factor, fmt::format("it is to be closed in u, but its last {} rows do not repeat the first ones.", degree));
}

/// Base knots are some of the factor's own, as multiple or less, in order.
void requireBase(const char* factor, const char* direction, const std::vector<double>& base, const SplineSpace& space) {
  const std::vector<double> own = innerKnots(space);
  auto next = own.begin();
  for (const double knot : base) {
    next = std::lower_bound(next, own.end(), knot);
    if (next == own.end() || *next != knot)  // what is not a number is none of them, either
      fail(factor, fmt::format("its base knot {} = {} is none of its own knots inside the domain, or not in order.",
                               direction, knot));
    ++next;
  }
}

void requireBase(const Motion& motion) {
  requireBase("trajectory", "v", motion.base->trajectory, spaceOf(motion.trajectory));
  for (const auto& [name, surface, base] :
       {std::tuple<const char*, const Surface&, const std::array<std::vector<double>, 2>&>{"orientation", motion.orientation,
                                                                                           motion.base->orientation},
        {"scaling", motion.scaling, motion.base->scaling}}) {
    requireBase(name, "u", base[0], spaceInU(surface, motion.closedU == ClosedU::No ? 0 : 1));
    requireBase(name, "v", base[1], spaceInV(surface));
  }
}

}  // namespace

int seamMultiplicity(const std::vector<double>& periodU) {
  const auto first = std::find_if(periodU.begin(), periodU.end(), [&](double k) { return k != periodU.front(); });
  const auto last = std::find_if(periodU.rbegin(), periodU.rend(), [&](double k) { return k != periodU.back(); });
  return static_cast<int>(first - periodU.begin()) + static_cast<int>(last - periodU.rbegin()) - 1;
}

Surface unwrapped(int degreeU, int degreeV, const std::vector<double>& periodU, std::vector<double> knotsV,
                  std::vector<Vec4> poles, double sign) {
  const std::size_t rows = periodU.size() - 1, columns = knotsV.size() - static_cast<std::size_t>(degreeV) - 1;
  Surface surface{degreeU, degreeV, unwrappedKnots(degreeU, periodU), std::move(knotsV), std::move(poles)};
  surface.poles.reserve((rows + static_cast<std::size_t>(degreeU)) * columns);
  for (std::size_t i = rows; i < rows + static_cast<std::size_t>(degreeU); ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const Vec4 pole = sign * surface.poles[(i - rows) * columns + j];
      surface.poles.push_back(pole);
    }
  return surface;
}

void validate(const Motion& motion) {
  validateFactor("trajectory", motion.trajectory);
  validateFactor("orientation", motion.orientation);
  validateFactor("scaling", motion.scaling);
  requireSameDomain("trajectory", "v", motion.trajectory.domain(), motion.domainV());
  requireSameDomain("scaling", "u", motion.scaling.domainU(), motion.domainU());
  requireSameDomain("scaling", "v", motion.scaling.domainV(), motion.domainV());
  requireContinuity("trajectory", motion.trajectory.degree, motion.trajectory.knots);
  for (const auto& [name, factor] :
       {std::pair<const char*, const Surface&>{"orientation", motion.orientation}, {"scaling", motion.scaling}}) {
    requireContinuity(name, factor.degreeU, factor.knotsU);
    requireContinuity(name, factor.degreeV, factor.knotsV);
  }
  for (const Vec4& pole : motion.trajectory.poles)
    if (pole[3] <= 0) fail("trajectory", "every weight must be above 0.");
  for (const Vec4& pole : motion.scaling.poles)
    if (pole[3] <= 0) fail("scaling", "every fourth component (sw) must be above 0.");
  if (!motion.point.allFinite()) fail("point", "its coordinates must be finite numbers.");
  if (motion.base) requireBase(motion);
  if (motion.closedU == ClosedU::No) return;
  requireClosed("orientation", motion.orientation, motion.closedU == ClosedU::AntiPeriodic ? -1.0 : 1.0);
  requireClosed("scaling", motion.scaling, 1.0);
  requireContinuousSeam("orientation", motion.orientation);
  requireContinuousSeam("scaling", motion.scaling);
}

namespace {

/// Neighbours (this and the next in u, this and the next in v) that point away from each other.
void countOpposed(const Surface& r, QuaternionAlignment& result) {
  result.opposed = 0;
  for (std::size_t i = 0; i < r.countU(); ++i)
    for (std::size_t j = 0; j < r.countV(); ++j) {
      const bool opposed = (i + 1 < r.countU() && r.pole(i, j).dot(r.pole(i + 1, j)) < 0) ||
                           (j + 1 < r.countV() && r.pole(i, j).dot(r.pole(i, j + 1)) < 0);
      if (opposed && result.opposed++ == 0) result.row = i, result.column = j;
    }
}

/// Cosine of the half-angle from which a turn between neighbours is no longer taken as meant: 135 degrees, three quarters
/// of a full turn. Signs that were lost leave pairs near 180 degrees, between which the spline nearly vanishes.
constexpr double hardlyMeant = -0.70710678118654752;

/// The axis of the turn from one quaternion to the next, times the sine of its half-angle and their lengths.
Vec3 turnBetween(const Vec4& from, const Vec4& to) {
  const Vec3 a = from.tail<3>(), b = to.tail<3>();
  return from[0] * b - to[0] * a - a.cross(b);
}

/// On this line of poles, signs as they stand make sense: no neighbours point away from each other, or all turn the same
/// way and none too far.
bool turnsOneWay(const Surface& r, std::size_t start, std::size_t step, std::size_t count) {
  bool opposed = false, oneWay = true;
  Vec3 last = Vec3::Zero();
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const Vec4 &from = r.poles[start + k * step], &to = r.poles[start + (k + 1) * step];
    const double cosine = from.dot(to), lengths = from.norm() * to.norm();
    if (cosine < hardlyMeant * lengths) return false;
    opposed = opposed || cosine < 0;
    const Vec3 turn = turnBetween(from, to);
    oneWay = oneWay && turn.dot(last) >= 0;
    if (turn.norm() > 1e-9 * lengths) last = turn;
  }
  return !opposed || oneWay;
}

bool signsAreMeant(const Surface& r) {
  for (std::size_t i = 0; i < r.countU(); ++i)
    if (!turnsOneWay(r, i * r.countV(), 1, r.countV())) return false;
  for (std::size_t j = 0; j < r.countV(); ++j)
    if (!turnsOneWay(r, j, r.countV(), r.countU())) return false;
  return true;
}

}  // namespace

QuaternionAlignment alignQuaternions(Motion& motion) {
  QuaternionAlignment before, after;
  countOpposed(motion.orientation, before);
  if (before.opposed == 0 || signsAreMeant(motion.orientation)) return before;
  Surface aligned = motion.orientation;
  const std::size_t free =
      aligned.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(aligned.degreeU));
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < aligned.countV(); ++j) {
      if (i == 0 && j == 0) continue;
      Vec4& pole = aligned.pole(i, j);
      // Of two neighbours the one that is surer of the sign decides.
      const double alongU = i > 0 ? pole.dot(aligned.pole(i - 1, j)) : 0,
                   alongV = j > 0 ? pole.dot(aligned.pole(i, j - 1)) : 0;
      if ((std::abs(alongU) >= std::abs(alongV) ? alongU : alongV) < 0) pole = -pole, ++after.flipped;
    }
  const double sign = motion.closedU == ClosedU::AntiPeriodic ? -1.0 : 1.0;
  for (std::size_t i = free; i < aligned.countU(); ++i)
    for (std::size_t j = 0; j < aligned.countV(); ++j) aligned.pole(i, j) = sign * aligned.pole(i - free, j);
  countOpposed(aligned, after);
  if (after.opposed >= before.opposed) return before;
  motion.orientation = std::move(aligned);
  return after;
}

}  // namespace blossom
