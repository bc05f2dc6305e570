#include "kernel/begin/primitive_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/begin/turning_spline.h"
#include "kernel/grid/motion_point.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

using std::numbers::pi;

/// Spans for each turn of a helicoid.
constexpr double spansOfTurn = 16;
constexpr double mostTurns = 100;
constexpr std::size_t mostSpans = 256;

void requireSize(double value, const char* name, bool zeroAllowed = false) {
  if (!std::isfinite(value) || value < 0 || (value == 0 && !zeroAllowed))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The {} must be {} 0; it is {}.", name, zeroAllowed ? "at least" : "above", value));
}

void requireSections(const PrimitiveOptions& o) {
  if (!(o.profile < o.radius))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("A section of radius {} would cross the axis of a ring of radius {}.", o.profile, o.radius),
                "Make the profile smaller than the radius.");
}

void requireOptions(const PrimitiveOptions& o) {
  requireSize(o.radius, "radius");
  requireSize(o.height, "height");
  requireSize(o.width, "width");
  requireSize(o.profile, "profile");
  requireSize(o.topRadius, "top radius", true);
  const bool around = o.kind != PrimitiveKind::Helicoid && o.kind != PrimitiveKind::Plane && o.kind != PrimitiveKind::Sheet;
  if (o.rows < (around ? 4 : 1) || o.columns < 1 || o.rows > mostSpans || o.columns > mostSpans)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("A motion of this kind cannot have {} rows and {} columns.", o.rows, o.columns),
                fmt::format("Give {} to {} rows and 1 to {} columns.", around ? 4 : 1, mostSpans, mostSpans));
  if (!(o.angle > 0 && o.angle < 360))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The angle must lie above 0 and below 360 degrees; it is {}.", o.angle),
                "A whole ring is the torus.");
  if (!(std::abs(o.turns) > 0 && std::abs(o.turns) <= mostTurns))
    throw Error(ErrorCode::InvalidParameter, fmt::format("A helicoid cannot make {} turns.", o.turns),
                fmt::format("Give a number from -{0} to {0} that is not 0; below 0 it turns clockwise.", mostTurns));
}

/// Quaternions in u, unwrapped as far as they are to be: around a full turn the rows of one period.
struct TurnInU {
  bool closed = false;
  std::vector<double> knots;  ///< of one period when closed, else full
  std::vector<Vec4> poles;
};

TurnInU aroundAxis(std::size_t rows, const Vec3& axis) {
  TurnInU result{true, evenBreaks(rows), {}};
  for (const double half : closedTurn(rows)) result.poles.push_back(rotationAbout(axis, 2 * half));
  return result;
}

TurnInU openInU(const Curve& turn) { return {false, turn.knots, turn.poles}; }

/// The same turn everywhere.
Curve noTurn(std::size_t spans) {
  Curve result{3, clampedKnots(3, evenBreaks(spans)), {}};
  result.poles.assign(spans + 3, Vec4(1, 0, 0, 0));
  return result;
}

/// Tensor product: first the turn in u, then that in v.
Surface turnSurface(const TurnInU& u, const Curve& v) {
  std::vector<Vec4> poles;
  for (const Vec4& inner : u.poles)
    for (const Vec4& outer : v.poles) poles.push_back(times(outer, inner));
  if (u.closed) return unwrapped(3, 3, u.knots, v.knots, std::move(poles), -1);
  return {3, 3, u.knots, v.knots, std::move(poles)};
}

/// The first factor of the scaling, linear in u and in v; `scale` takes the parameters 0..1 to mm.
template <class Scale>
Surface scaleSurface(const TurnInU& u, std::size_t columns, Scale scale) {
  const std::vector<double> knotsV = clampedKnots(3, evenBreaks(columns));
  const std::vector<double> inV = grevilleAbscissae(3, knotsV);
  std::vector<double> inU(u.poles.size(), 0.0);  // a closed motion scales alike all around
  if (!u.closed) inU = grevilleAbscissae(3, u.knots);
  std::vector<Vec4> poles;
  for (const double atU : inU)
    for (const double atV : inV) poles.emplace_back(scale(atU, atV), 0, 0, 1);
  if (u.closed) return unwrapped(3, 3, u.knots, knotsV, std::move(poles), 1);
  return {3, 3, u.knots, knotsV, std::move(poles)};
}

template <class Scale>
Motion motionOf(Curve trajectory, const TurnInU& u, const Curve& v, std::size_t columns, Scale scale) {
  return {std::move(trajectory), turnSurface(u, v), scaleSurface(u, columns, scale),
          u.closed ? ClosedU::AntiPeriodic : ClosedU::No, Vec3::Ones()};
}

Motion coneMotion(const PrimitiveOptions& o, double top) {
  return motionOf(straightLine(o.columns, Vec3::Zero(), {0, 0, o.height}), aroundAxis(o.rows, Vec3::UnitZ()),
                  noTurn(o.columns), o.columns, [&](double, double v) { return o.radius + (top - o.radius) * v; });
}

/// Longitude in u; latitude in v, by a turn about y.
Motion sphereMotion(const PrimitiveOptions& o) {
  Curve latitude = openTurn(o.columns, pi / 2, -pi / 2);
  for (Vec4& pole : latitude.poles) std::swap(pole[2], pole[3]);
  // The turn about z is the outer one here: u and v exchange their places in the product.
  std::vector<Vec4> poles;
  const TurnInU around = aroundAxis(o.rows, Vec3::UnitZ());
  for (const Vec4& longitude : around.poles)
    for (const Vec4& pole : latitude.poles) poles.push_back(times(longitude, pole));
  Motion motion = motionOf(straightLine(o.columns, Vec3::Zero(), Vec3::Zero()), around, noTurn(o.columns), o.columns,
                           [&](double, double) { return o.radius; });
  motion.orientation = unwrapped(3, 3, around.knots, latitude.knots, std::move(poles), -1);
  return motion;
}

Motion ringMotion(const PrimitiveOptions& o, double angle) {
  // Fewer spans than four for each turn would let the poles point away from each other.
  const std::size_t spans = std::max(o.columns, static_cast<std::size_t>(std::ceil(angle / (pi / 2))));
  Curve turn = openTurn(spans, 0, angle);
  if (angle == fullTurn) {  // rounding must not leave the ring open
    turn.poles.back() = -turn.poles.front();
  }
  return motionOf(circleInStep(turn, o.radius), aroundAxis(o.rows, -Vec3::UnitY()), turn, spans,
                  [&](double, double) { return o.profile; });
}

Motion helicoidMotion(const PrimitiveOptions& o) {
  const double wanted = std::ceil(spansOfTurn * std::abs(o.turns) / static_cast<double>(o.columns));
  const std::size_t spans = o.columns * static_cast<std::size_t>(std::max(wanted, 1.0));
  return motionOf(straightLine(o.columns, Vec3::Zero(), {0, 0, o.height}), openInU(noTurn(o.rows)),
                  openTurn(spans, 0, o.turns * fullTurn), o.columns, [&](double u, double) { return o.radius * u; });
}

Motion planeMotion(const PrimitiveOptions& o) {
  return motionOf(straightLine(o.columns, {0, -o.height / 2, 0}, {0, o.height / 2, 0}), openInU(noTurn(o.rows)),
                  noTurn(o.columns), o.columns, [&](double u, double) { return o.width * (u - 0.5); });
}

/// Its middle line stands over x.
Motion sheetMotion(const PrimitiveOptions& o) {
  const double half = toRadians(o.angle) / 2;
  const std::size_t spans = std::max(o.rows, static_cast<std::size_t>(std::ceil(2 * half / (pi / 2))));
  return motionOf(straightLine(o.columns, Vec3::Zero(), {0, 0, o.height}), openInU(openTurn(spans, -half, half)),
                  noTurn(o.columns), o.columns, [&](double, double) { return o.radius; });
}

/// Largest distance along z from z = height a / (2 pi turns), a the angle about z.
double helicoidDeviation(const Motion& motion, const PrimitiveOptions& o) {
  const BezierSurface pieces = toBezier(motion.orientation);
  double largest = 0;
  for (std::size_t k = 0; k + 1 < pieces.breaksV.size(); ++k)
    for (int i = 0; i <= 16; ++i) {
      const double v = pieces.breaksV[k] + (pieces.breaksV[k + 1] - pieces.breaksV[k]) * i / 16;
      const Vec3 at = evaluate(motion, 1, v).point;
      const double wanted = fullTurn * o.turns * v, off = std::remainder(std::atan2(at.y(), at.x()) - wanted, fullTurn);
      largest = std::max(largest, std::abs(off * o.height / (fullTurn * o.turns)));
    }
  return largest;
}

}  // namespace

PrimitiveResult primitiveMotion(const PrimitiveOptions& o) {
  requireOptions(o);
  switch (o.kind) {
    case PrimitiveKind::Cylinder:
      return {coneMotion(o, o.radius), 0};
    case PrimitiveKind::Cone:
      return {coneMotion(o, o.topRadius), 0};
    case PrimitiveKind::Sphere:
      return {sphereMotion(o), 0};
    case PrimitiveKind::Torus:
      requireSections(o);
      return {ringMotion(o, fullTurn), 0};
    case PrimitiveKind::Tube:
      requireSections(o);
      return {ringMotion(o, toRadians(o.angle)), 0};
    case PrimitiveKind::Helicoid: {
      PrimitiveResult result{helicoidMotion(o), 0};
      result.deviation = helicoidDeviation(result.motion, o);
      return result;
    }
    case PrimitiveKind::Plane:
      return {planeMotion(o), 0};
    case PrimitiveKind::Sheet:
      return {sheetMotion(o), 0};
  }
  throw Error(ErrorCode::Internal, "There is no such kind of motion.");
}

}  // namespace blossom::sweep
