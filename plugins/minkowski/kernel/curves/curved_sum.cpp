#include "kernel/curves/curved_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"
#include "kernel/convolution.h"
#include "kernel/curves/convex_sum.h"
#include "kernel/curves/curve_fitting.h"
#include "kernel/curves/sampled_region.h"
#include "kernel/flattening.h"
#include "kernel/nesting.h"
#include "kernel/polygon_sum.h"
#include "kernel/snap_rounding.h"
#include "kernel/snapped_operands.h"
#include "kernel/winding/winding_faces.h"

namespace blossom::minkowski {
namespace {

CornerNumbers numbersOf(const SampledRegion& region, const Grid& grid) {
  CornerNumbers numbers;
  for (const SampledSide& side : region.sides) numbers.add(grid.nearest(side.from), grid.nearest(side.to));
  return numbers;
}

/// The tolerance within which corners of polygons and of curves correspond: the longest chord, about which crossings of
/// nearly tangent curves move.
double longestChord(const SampledRegion& region) {
  double longest = 0;
  for (const SampledSide& side : region.sides)
    if (side.curve) longest = std::max(longest, (side.to - side.from).norm());
  return longest;
}

/// How far rounding moves points of a sum and the centres and radii of its arcs.
double roundingOf(const SampledRegion& a, const SampledRegion& b, const Grid& grid) {
  double farthest = 0;
  for (const SampledRegion* region : {&a, &b}) {
    for (const SampledCorner& corner : region->corners) farthest = std::max(farthest, corner.at.cwiseAbs().maxCoeff());
    for (const BoundaryCurve& arc : region->curves)
      farthest = std::max(farthest, arc.centre.cwiseAbs().maxCoeff() + std::abs(arc.radius));
  }
  return 64 * grid.unit + 32 * std::numeric_limits<double>::epsilon() * farthest;
}

/// How the polygons of two regions are added.
struct Addition {
  Sampling sampling = Sampling::Chords;
  Inside inside = Inside::Positive;
};

/// The sum of two regions by polygons within a share of the tolerances.
class SampledSum {
 public:
  SampledSum(const SoundRegion& a, const SoundRegion& b, double share, const Addition& addition, const Progress& progress,
             Effort& effort)
      : tolerance_(share * (a.tolerance + b.tolerance)) {
    a_ = sampled(a, share, normalsOf(b, a, share), addition.sampling, progress);
    b_ = sampled(b, share, normalsOf(a, b, share), addition.sampling, progress);
    const SnappedOperands operands = snappedTogether(a_.polygons, b_.polygons);
    grid_ = operands.gridOfSum;
    sources_.first = numbersOf(a_, operands.gridA);
    sources_.second = numbersOf(b_, operands.gridB);
    const std::vector<GridPolygon> ofA = untangled(operands.a, progress), ofB = untangled(operands.b, progress);
    const std::optional<ConvexCore> core = addition.inside == Inside::Positive ? coreOfSum(ofA, ofB) : std::nullopt;
    edges_ = convolution(ofA, ofB, progress.part(0, 0.1), effort, &sources_, core ? &*core : nullptr);
    faces_ = tracedFaces(edges_, progress.part(0.1, 0.9), addition.inside, effort);
  }

  /// Nothing when the polygons are too coarse.
  [[nodiscard]] std::optional<Region> curves(const Progress& progress) const {
    const CurveFitting fitting{
        .rounding = roundingOf(a_, b_, grid_), .reach = 2 * (longestChord(a_) + longestChord(b_)), .gap = 4 * tolerance_};
    const auto curveOf = [&](std::uint32_t edge) { return curveOfEdge(edges_[edge], fitting.rounding); };
    return fittedCurves(faces_, grid_, curveOf, fitting, progress);
  }

  [[nodiscard]] Region lines() const {
    Polygons polygons;
    for (const TracedPart& part : faces_) {
      Polygon& polygon = polygons.emplace_back(Polygon{part.outer.corners, {}});
      for (const TracedLoop& hole : part.holes) polygon.holes.push_back(hole.corners);
    }
    return toRegion(onPlane(polygons, grid_));
  }

 private:
  [[nodiscard]] std::optional<TrueCurve> curveOfEdge(const CountedEdge& edge, double rounding) const {
    if (edge.source == 0) {
      const auto place = [&](const GridPoint& p) {
        return grid_.point(Vec2(static_cast<double>(p.x), static_cast<double>(p.y)));
      };
      return StraightCurve{place(edge.from), place(edge.to)};
    }
    const PairSources::Pair& pair = sources_.all[edge.source];
    if (pair.edgeOfFirst) return curveOfPair(a_, pair.edge, b_, pair.corner, rounding);
    std::optional<TrueCurve> curve = curveOfPair(b_, pair.edge, a_, pair.corner, rounding);
    if (curve && isFree(*curve)) std::swap(std::get<FreeSide>(*curve).name[0], std::get<FreeSide>(*curve).name[1]);
    return curve;
  }

  double tolerance_;
  SampledRegion a_, b_;
  Grid grid_;
  PairSources sources_;
  std::vector<CountedEdge> edges_;
  std::vector<TracedPart> faces_;
};

/// By polygons that become finer until the curves fit.
Region fittedSum(const SoundRegion& a, const SoundRegion& b, const Addition& addition, const Progress& progress,
                 Effort& effort) {
  constexpr int attempts = 3;
  constexpr double finer = 1.0 / 8;
  double share = 1, done = 0;
  std::optional<Region> lines;
  for (int i = 0; i < attempts; ++i, share *= finer, done = (1 + done) / 2) {
    progress.check();
    try {
      const SampledSum sum(a, b, share, addition, progress.part(done, (1 + done) / 2), effort);
      if (auto curves = sum.curves(progress)) return *std::move(curves);
      if (!lines) lines = sum.lines();
    } catch (const Error& error) {
      if (!lines || error.code() != ErrorCode::LimitExceeded) throw;  // finer polygons are too many
      break;
    }
  }
  return *std::move(lines);
}

/// When one set is as good as a point beside the other: the other, moved there.
std::optional<SoundRegion> sumWithPoint(const SoundRegion& a, const SoundRegion& b) {
  const auto boxOfShape = [](const SoundRegion& shape) {
    Box2 box;
    for (const Path& loop : shape.region.loops)
      for (const Segment& segment : loop.segments) {
        box.extend(startPoint(segment));
        if (const auto* arc = std::get_if<Arc2>(&segment)) {
          box.extend(Vec2(arc->center + Vec2::Constant(arc->radius)));
          box.extend(Vec2(arc->center - Vec2::Constant(arc->radius)));
        }
        if (const auto* spline = std::get_if<Spline2>(&segment))
          for (const Vec3& pole : spline->poles) box.extend(euclidean(pole));
      }
    return box;
  };
  constexpr double point = 3e-12;
  const Box2 boxA = boxOfShape(a), boxB = boxOfShape(b);
  if (boxB.sizes().norm() <= point * boxA.sizes().norm()) return translated(a, boxB.center());
  if (boxA.sizes().norm() <= point * boxB.sizes().norm()) return translated(b, boxA.center());
  return std::nullopt;
}

Box2 boxOf(const std::vector<Loop>& loops) {
  Box2 box;
  for (const Loop& loop : loops)
    for (const Vec2& p : loop) box.extend(p);
  return box;
}

std::vector<Loop> flattenedLoops(const SoundRegion& shape) {
  std::vector<Loop> loops;
  for (const Path& loop : shape.region.loops) loops.push_back(flatten(loop, shape.tolerance));
  return loops;
}

Path framePath(const Vec2& low, const Vec2& high) {
  const Vec2 right(high.x(), low.y()), left(low.x(), high.y());
  return {{Line2{low, right}, Line2{right, high}, Line2{high, left}, Line2{left, low}}, true, {}, {}};
}

/// The complement of A within a frame that B, wherever it meets A, does not reach. Nothing where loops of A touch, as those
/// of an earlier result may.
std::optional<SoundRegion> complement(const SoundRegion& a, const SoundRegion& b, const Progress& progress) {
  const std::vector<Loop> loopsOfA = flattenedLoops(a);
  const Box2 boxA = boxOf(loopsOfA), boxB = boxOf(flattenedLoops(b));
  const Vec2 reach = 2 * boxB.sizes() + boxA.sizes();
  std::vector<Path> paths{framePath(boxA.min() - reach, boxA.max() + reach)};
  std::vector<Loop> loops{flatten(paths.front(), a.tolerance)};
  for (std::size_t i = 0; i < loopsOfA.size(); ++i) {
    paths.push_back(reversed(a.region.loops[i]));
    loops.emplace_back(loopsOfA[i].rbegin(), loopsOfA[i].rend());
  }
  const auto parts = Nesting(std::move(loops), progress).parts();
  if (!parts) return std::nullopt;
  SoundRegion result{{}, a.tolerance};
  for (const auto& [outer, holes] : *parts) {
    result.region.loops.push_back(paths[outer]);
    for (const std::size_t hole : holes) result.region.loops.push_back(paths[hole]);
  }
  return result;
}

}  // namespace

SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.region.loops.empty() || b.region.loops.empty()) return {};
  const double tolerance = a.tolerance + b.tolerance;
  if (!hasCurves(a.region) && !hasCurves(b.region))
    return {toRegion(sum(toPolygons(a), toPolygons(b), progress, effort)), tolerance};
  if (auto moved = sumWithPoint(a, b)) return *std::move(moved);
  if (!hasSplines(a.region) && !hasSplines(b.region) && isConvex(a) && isConvex(b))
    return {convexSum(a.region, b.region), tolerance};
  return {fittedSum(a, b, {}, progress, effort), tolerance};
}

SoundRegion difference(const SoundRegion& a, const SoundRegion& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.region.loops.empty()) return {};
  const double tolerance = a.tolerance + b.tolerance;
  if (!hasCurves(a.region) && !hasCurves(b.region))
    return {toRegion(difference(toPolygons(a), toPolygons(b), progress, effort)), tolerance};
  const Addition leftOut{Sampling::Around, Inside::Hollow};
  if (const auto around = complement(a, b, progress))
    return {fittedSum(*around, scaled(b, -1), leftOut, progress, effort), tolerance};
  // By polygons on the safe side, whose loops may touch.
  return {toRegion(difference(flattened(a.region, {.side = Approximation::Inside, .effort = &effort}, "shape 1", progress),
                              flattened(b.region, {.side = Approximation::Outside, .effort = &effort}, "shape 2", progress),
                              progress, effort)),
          tolerance};
}

}  // namespace blossom::minkowski
