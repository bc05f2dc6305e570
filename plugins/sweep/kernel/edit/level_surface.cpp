#include "kernel/edit/level_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/grid/basis_table.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t mostPoles = 1'000'000;
/// As in kernel/edit/place_row.h: with smaller shares, rounding would be enlarged a million times.
constexpr double smallestPart = 1e-6;
/// Copies of an edit stand around the motion, all of them at the same v: nothing has to repeat along it.
constexpr int partsAlongV = 1;

/// One direction of an edit: where its functions reach, and the space that has them.
struct LevelLine {
  std::vector<Reach> reaches;
  SplineSpace space;
};

/// Of coarser levels the whole space is taken, of finer ones what lies around the places. @param parts see levelSpace
LevelLine levelLine(const SplineSpace& base, int level, int parts, const std::vector<double>& at) {
  LevelLine line;
  line.space = levelSpace(base, level, parts);
  for (const double t : at) line.reaches.push_back(reachAt(line.space, t));
  if (level > 0) line.space = refinedInside(base, line.space, line.reaches);
  return line;
}

SplineSpace unionOf(const SplineSpace& now, const SplineSpace& other) {
  const std::vector<double> own = innerKnots(now), all = unitedKnots(own, innerKnots(other));
  return all == own ? now : withInnerKnots(now, all);
}

template <double MotionPlace::*parameter>
std::vector<double> parametersOf(std::span<const MotionPlace> places) {
  std::vector<double> all;
  for (const MotionPlace& each : places) all.push_back(each.*parameter);
  return all;
}

void requirePossible(const SplineSpace& u, const SplineSpace& v) {
  if (u.size() * v.size() > mostPoles)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("A factor of this motion would get {} x {} poles for the edit; at most {} are possible.",
                            u.size(), v.size(), mostPoles),
                "Edit it at a coarser level, or at fewer places.");
}

HierarchicalSurface nothing(const SplineSpace& u, const SplineSpace& v) {
  return {u, v, std::vector<Vec4>(u.size() * v.size(), Vec4::Zero())};
}

HierarchicalSurface changeOver(const SplineSpace& baseU, const SplineSpace& baseV, const EditLevel& level,
                               const LevelLine& u, const LevelLine& v) {
  if (level.level <= 0) return nothing(u.space, v.space);
  HierarchicalSurface change = nothing(baseU, baseV);
  std::vector<ParameterBox> boxes;
  for (std::size_t k = 0; k < u.reaches.size(); ++k)
    boxes.push_back({u.reaches[k].first, u.reaches[k].second, v.reaches[k].first, v.reaches[k].second});
  change.refine(u.space, v.space, boxes);
  return change;
}

/// The copies of the functions cancel each other.
bool cancelledAt(const SplineSpace& space, double t) {
  if (space.closure == 0) return false;
  double alone = 0, summed = 0;
  const BasisTable basis = tabulateBasis(space.degree, space.knots, {&t, 1});
  for (const double value : basis.value) alone += value * value;
  for (const FunctionValue& each : functionsAt(space, t)) summed += each.value * each.value;
  return summed < smallestPart * smallestPart * alone;
}

/// The space in which a factor lies along v.
SplineSpace spaceAlong(const SplineSpace& clamped, const std::optional<JoinedEnds>& ring) {
  return ring ? ringSpace(clamped, *ring) : clamped;
}

}  // namespace

LevelSurface::LevelSurface(const Surface& factor, double closure, const std::array<std::vector<double>, 2>& base,
                           const EditLevel& level, std::span<const MotionPlace> places,
                           const std::optional<JoinedEnds>& ring)
    : closure_(closure), nowU_(spaceInU(factor, closure)), nowV_(spaceInV(factor)) {
  const SplineSpace baseU = withInnerKnots(nowU_, base[0]), baseV = withInnerKnots(spaceAlong(nowV_, ring), base[1]);
  const LevelLine u = levelLine(baseU, level.level, level.parts, parametersOf<&MotionPlace::u>(places)),
                  v = levelLine(baseV, level.level, partsAlongV, parametersOf<&MotionPlace::v>(places));
  refinedU_ = unionOf(nowU_, u.space), refinedV_ = unionOf(nowV_, v.space);
  requirePossible(refinedU_, refinedV_);
  change_ = changeOver(baseU, baseV, level, u, v);
  const SplineSpace all = spaceAlong(refinedV_, ring);
  toRefinedV_ = embedding(change_.spaceV(change_.levels() - 1), all);
  if (ring) toRefinedV_ = composed(toRefinedV_, SeamV(refinedV_, *ring).fromFunctions(all));
}

PlaceRow LevelSurface::row(const MotionPlace& at) const {
  const std::size_t level = change_.levels() - 1;
  PlaceRow row;
  row.cancelled = cancelledAt(change_.spaceU(level), at.u) || cancelledAt(change_.spaceV(level), at.v);
  if (row.cancelled) return row;
  for (const HierarchicalSurface::ActiveValue& each : change_.activeAt(at.u, at.v)) {
    if (each.level != level) continue;
    row.pole.push_back(each.function);
    row.share.push_back(each.value);
  }
  return row;
}

std::size_t LevelSurface::apply(const PoleChange& wanted, Surface& factor) const {
  HierarchicalSurface change = change_;
  for (std::size_t k = 0; k < wanted.pole.size(); ++k)
    change.setCoefficient(change.levels() - 1, wanted.pole[k], wanted.by.row(static_cast<Eigen::Index>(k)).transpose());
  const std::vector<Vec4> by =
      mapped(embedding(change.spaceU(change.levels() - 1), refinedU_), toRefinedV_, change.finest());
  const std::size_t columns = refinedV_.size(), free = refinedU_.size();
  if (!(refinedU_ == nowU_ && refinedV_ == nowV_)) {
    factor.poles.resize(nowU_.size() * nowV_.size());  // without the rows that repeat others
    factor.poles = mapped(embedding(nowU_, refinedU_), embedding(nowV_, refinedV_), factor.poles);
    factor.knotsU = refinedU_.knots, factor.knotsV = refinedV_.knots;
    factor.poles.resize(factor.countU() * columns);
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < by.size(); ++k) {
    if (by[k].isZero(0)) continue;
    const Vec4 before = factor.poles[k];
    factor.poles[k] += by[k];
    if (factor.poles[k] != before) ++count;
  }
  for (std::size_t k = free * columns; k < factor.poles.size(); ++k)
    factor.poles[k] = closure_ * factor.poles[k - free * columns];
  return count;
}

LevelCurve::LevelCurve(const Curve& trajectory, const std::vector<double>& base, const EditLevel& level,
                       std::span<const MotionPlace> places, const std::optional<JoinedEnds>& ring)
    : refined_(trajectory) {
  const SplineSpace now = spaceOf(trajectory);
  SplineSpace along = spaceAlong(now, ring);
  if (ring) along.closure = 1;
  const LevelLine line =
      levelLine(withInnerKnots(along, base), level.level, partsAlongV, parametersOf<&MotionPlace::v>(places));
  const SplineSpace refined = unionOf(now, line.space);
  if (!(refined == now)) {
    refined_.poles = mapped(embedding(now, refined), trajectory.poles);
    refined_.knots = refined.knots;
  }
  const SplineSpace all = withInnerKnots(along, innerKnots(refined));
  toRefined_ = embedding(line.space, all);
  if (ring) toRefined_ = composed(toRefined_, SeamV(refined_, *ring).fromFunctions(all));
  const std::size_t order = static_cast<std::size_t>(now.degree) + 1;
  for (std::size_t i = 0; i < line.space.size(); ++i) {
    const Reach support{line.space.knots[i], line.space.knots[i + order]};
    active_.push_back(level.level <= 0 || std::any_of(line.reaches.begin(), line.reaches.end(), [&](const Reach& reach) {
                        return liesWithin(line.space, support, reach);
                      }));
  }
}

PlaceRow LevelCurve::row(double v) const {
  const PlaceRow fine = placeRow(refined_, v);
  std::vector<double> shares(active_.size(), 0.0);
  for (std::size_t k = 0; k < fine.pole.size(); ++k)
    for (std::size_t e = toRefined_.begin[fine.pole[k]]; e < toRefined_.begin[fine.pole[k] + 1]; ++e)
      shares[toRefined_.coarse[e]] += fine.share[k] * toRefined_.weight[e];
  PlaceRow row;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] == 0 || !active_[i]) continue;
    row.pole.push_back(i);
    row.share.push_back(shares[i]);
  }
  return row;
}

std::size_t LevelCurve::apply(const PoleChange& wanted, Curve& trajectory) const {
  std::vector<Vec3> coefficients(active_.size(), Vec3::Zero());
  for (std::size_t k = 0; k < wanted.pole.size(); ++k)
    coefficients[wanted.pole[k]] = wanted.by.row(static_cast<Eigen::Index>(k)).transpose();
  trajectory = refined_;
  std::size_t count = 0;
  for (std::size_t j = 0; j < trajectory.poles.size(); ++j) {
    Vec3 by = Vec3::Zero();
    for (std::size_t e = toRefined_.begin[j]; e < toRefined_.begin[j + 1]; ++e)
      by += toRefined_.weight[e] * coefficients[toRefined_.coarse[e]];
    if (by.isZero(0)) continue;
    Vec4& pole = trajectory.poles[j];
    const Vec4 before = pole;
    pole.head<3>() += pole[3] * by;
    if (pole != before) ++count;
  }
  return count;
}

}  // namespace blossom::sweep
