#include "manipulators/edit_region.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/edit/edit_level.h"
#include "kernel/edit/motion_symmetry.h"
#include "kernel/edit/place_row.h"
#include "kernel/edit/seam_v.h"
#include "manipulators/place_under_mouse.h"

namespace blossom::sweep {

namespace {

constexpr int lineSamples = 96;

/// A part of a line ends where the surface turns away.
void addLine(const std::vector<PlaceHit>& points, const Vec3& towards, double side, SurfaceLines& lines) {
  const auto faces = [&](const PlaceHit& p) { return p.normal.dot(towards) * side >= 0; };
  for (std::size_t i = 0; i + 1 < points.size();) {
    const bool facing = faces(points[i]);
    std::vector<Vec3> part{points[i].point};
    do part.push_back(points[++i].point);
    while (i + 1 < points.size() && faces(points[i]) == facing);
    (facing ? lines.facing : lines.averted).push_back(std::move(part));
  }
}

/// v inside its range: the next period of a ring, or an end that rounding has passed.
double insideRangeOfV(const Motion& motion, double v) {
  const auto [first, last] = motion.domainV();
  constexpr double rounding = 1e-9;
  if (v < first) return v + (last - first);
  return v > last + rounding * (last - first) ? v - (last - first) : std::min(v, last);
}

void addLine(const Motion& motion, MotionPlace from, MotionPlace to, const Vec3& towards, double side, SurfaceLines& lines) {
  std::vector<PlaceHit> points;
  for (int i = 0; i <= lineSamples; ++i) {
    const double t = static_cast<double>(i) / lineSamples;
    const MotionPlace at{from.u + (to.u - from.u) * t, from.v + (to.v - from.v) * t};
    points.push_back(placeHit(motion, {insidePeriod(motion, at.u), insideRangeOfV(motion, at.v)}));
  }
  addLine(points, towards, side, lines);
}

void widen(std::pair<double, double>& range, std::pair<double, double> by) {
  range = {std::min(range.first, by.first), std::max(range.second, by.second)};
}

}  // namespace

SurfaceLines isoCurvesThrough(const Motion& motion, const MotionPlace& at, const Vec3& towards, double side) {
  SurfaceLines lines;
  const auto [firstU, lastU] = motion.domainU();
  const auto [firstV, lastV] = motion.domainV();
  addLine(motion, {firstU, at.v}, {lastU, at.v}, towards, side, lines);
  addLine(motion, {at.u, firstV}, {at.u, lastV}, towards, side, lines);
  return lines;
}

EditRegion editRegion(const Motion& motion, const MotionPlace& at, const PullMode& mode) {
  const PullWeights weights = mode.weights();
  const bool sections = weights.translate > 0;
  const BaseKnots base = baseKnots(motion);
  const auto reach = [&](const SplineSpace& now, const std::vector<double>& knots, int parts, double t) {
    return reachAt(levelSpace(withInnerKnots(now, knots), mode.level(), parts), t);
  };
  // Copies stand around the motion, at one v.
  const int aroundU = mode.symmetry().fold, alongV = 1;
  std::pair<double, double> u{at.u, at.u}, v{at.v, at.v};
  const auto joined = joinedInV(motion);
  const auto addV = [&](const SplineSpace& now, const std::vector<double>& knots, JoinedEnds JoinedFactors::*ends) {
    widen(v, reach(joined ? ringSpace(now, *joined.*ends) : now, knots, alongV, at.v));
  };
  const auto add = [&](const Surface& factor, double closure, const std::array<std::vector<double>, 2>& knots,
                       JoinedEnds JoinedFactors::*ends) {
    widen(u, reach(spaceInU(factor, closure), knots[0], aroundU, at.u));
    addV(spaceInV(factor), knots[1], ends);
  };
  if (sections) {
    u = motion.domainU();
    addV(spaceOf(motion.trajectory), base.trajectory, &JoinedFactors::trajectory);
  }
  if (mode.twists() || weights.rotate > 0)
    add(motion.orientation, closureOfOrientation(motion), base.orientation, &JoinedFactors::orientation);
  if (weights.scale > 0) add(motion.scaling, closureOfScaling(motion), base.scaling, &JoinedFactors::scaling);
  const auto lengthOf = [](std::pair<double, double> range) { return range.second - range.first; };
  const bool along = joined && lengthOf(v) >= lengthOf(motion.domainV());
  if (along) v = motion.domainV();
  return {u.first,
          u.second,
          v.first,
          v.second,
          sections || (motion.closedU != ClosedU::No && lengthOf(u) >= lengthOf(motion.domainU())),
          joined && !along};
}

std::vector<EditRegion> editRegions(const Motion& motion, const MotionPlace& at, const PullMode& mode) {
  std::vector<EditRegion> regions{editRegion(motion, at, mode)};
  if (regions.front().around || mode.symmetry() == EditSymmetry{}) return regions;
  try {
    const std::vector<SymmetricPlace> places = symmetricPlaces(motion, at, mode.symmetry());
    for (std::size_t k = 1; k < places.size(); ++k) regions.push_back(editRegion(motion, places[k].at, mode));
  } catch (const Error&) {
    regions.resize(1);  // the hint says why
  }
  return regions;
}

SurfaceLines borderOf(const Motion& motion, const EditRegion& region, const Vec3& towards, double side) {
  SurfaceLines lines;
  const double firstU = region.around ? motion.domainU().first : region.firstU,
               lastU = region.around ? motion.domainU().second : region.lastU;
  for (const double v : {region.firstV, region.lastV})
    if (region.ring || (v > motion.domainV().first && v < motion.domainV().second))
      addLine(motion, {firstU, v}, {lastU, v}, towards, side, lines);
  for (const double u : {region.firstU, region.lastU})
    if (!region.around && (motion.closedU != ClosedU::No || (u > motion.domainU().first && u < motion.domainU().second)))
      addLine(motion, {u, region.firstV}, {u, region.lastV}, towards, side, lines);
  return lines;
}

}  // namespace blossom::sweep
