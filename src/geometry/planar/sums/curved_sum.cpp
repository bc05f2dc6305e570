#include "geometry/planar/sums/curved_sum.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/finer_polygons.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/sums/complement.h"
#include "geometry/planar/sums/convex_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/sampled_sum.h"

namespace blossom::planar {
namespace {

/// How the polygons of two regions are added.
struct Addition {
  Sampling sampling = Sampling::Chords;
  Inside inside = Inside::Positive;
  const SampledPair* kept = nullptr;  ///< of both, within the tolerances
};

Region fittedSum(const SoundRegion& a, const SoundRegion& b, const Addition& addition, const Progress& progress,
                 Effort& effort) {
  const auto attempt = [&](double share, const Progress& part) {
    SampledPair pair = share == 1 && addition.kept ? *addition.kept : sampledPair(a, b, share, addition.sampling, part);
    return SampledSum(std::move(pair), share * (a.tolerance + b.tolerance), addition.inside, part, effort);
  };
  return byFinerPolygons(attempt, progress);
}

/// A nearly straight arc counts by what is drawn of it, not by its circle.
Box2 drawnBox(const Region& region) {
  Box2 box;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) box.extend(boxAround(segment));
  return box;
}

/// When one set is as good as a point beside the other: the other, moved there.
std::optional<SoundRegion> sumWithPoint(const SoundRegion& a, const SoundRegion& b) {
  constexpr double point = 3e-12;
  const Box2 boxA = drawnBox(a.region), boxB = drawnBox(b.region);
  if (boxB.sizes().norm() <= point * boxA.sizes().norm()) return translated(a, boxB.center());
  if (boxA.sizes().norm() <= point * boxB.sizes().norm()) return translated(b, boxA.center());
  return std::nullopt;
}

/// @param kept samples of both within the tolerances, or null
SoundRegion sumBy(const SampledPair* kept, const SoundRegion& a, const SoundRegion& b, const Progress& progress,
                  Effort& effort) {
  progress.check();
  if (a.region.loops.empty() || b.region.loops.empty()) return {};
  const double tolerance = a.tolerance + b.tolerance;
  if (!hasCurves(a.region) && !hasCurves(b.region))
    return {toRegion(sum(toPolygons(a), toPolygons(b), progress, effort)), tolerance};
  if (auto moved = sumWithPoint(a, b)) return *std::move(moved);
  if (!hasSplines(a.region) && !hasSplines(b.region) && isConvex(a) && isConvex(b))
    return {convexSum(a.region, b.region, progress), tolerance};
  return {fittedSum(a, b, {.kept = kept}, progress, effort), tolerance};
}

/// A whole disc, in however many arcs it is drawn; the first one, going round.
std::optional<Arc2> discOf(const Region& region) {
  if (region.loops.size() != 1) return std::nullopt;
  constexpr double rounding = 1e-14;
  std::optional<Arc2> disc;
  for (const Segment& segment : region.loops.front().segments) {
    const auto* arc = std::get_if<Arc2>(&segment);
    if (!arc || arc->sweep <= 0) return std::nullopt;
    if (!disc) disc = *arc;
    const double within = rounding * (disc->center.norm() + disc->radius);
    if ((arc->center - disc->center).norm() > within || std::abs(arc->radius - disc->radius) > within) return std::nullopt;
  }
  if (disc) disc->sweep = fullTurn;
  return disc;
}

/// Where the centre of one disc may be inside of the other, whose polygons would nearly cover each other.
std::optional<Region> roomOfDisc(const Region& a, const Region& b) {
  const std::optional<Arc2> around = discOf(a), disc = discOf(b);
  if (!around || !disc) return std::nullopt;
  const double radius = around->radius - disc->radius;
  const Vec2 centre = around->center - disc->center;
  const double rounding = 1e-15 * (around->radius + around->center.norm() + disc->center.norm());
  if (radius <= rounding) return Region();
  Path room;
  room.closed = true;
  room.segments = {Arc2{centre, radius, around->start, fullTurn}};
  return Region{{std::move(room)}};
}

}  // namespace

SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const Progress& progress, Effort& effort) {
  return sumBy(nullptr, a, b, progress, effort);
}

SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const SampledPair& kept, const Progress& progress,
                Effort& effort) {
  return sumBy(&kept, a, b, progress, effort);
}

SoundRegion difference(const SoundRegion& a, const SoundRegion& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.region.loops.empty()) return {};
  const double tolerance = a.tolerance + b.tolerance;
  if (!hasCurves(a.region) && !hasCurves(b.region))
    return {toRegion(difference(toPolygons(a), toPolygons(b), progress, effort)), tolerance};
  if (auto room = roomOfDisc(a.region, b.region)) return {*std::move(room), tolerance};
  const bool free = hasSplines(a.region) || hasSplines(b.region);
  if (!free)
    if (const auto around = complement(a, extentOf(b).sizes(), progress))
      return {fittedSum(*around, scaled(b, -1), {Sampling::Around, Inside::Hollow}, progress, effort), tolerance};
  // By polygons on the safe side, whose loops may touch.
  const Polygons inside = polygonsBeside(a, Approximation::Inside, "shape 1", progress, effort),
                 outside = polygonsBeside(b, Approximation::Outside, "shape 2", progress, effort);
  return {toRegion(difference(inside, outside, progress, effort)), tolerance, !free};
}

}  // namespace blossom::planar
