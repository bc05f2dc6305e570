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
#include "kernel/curves/finer_polygons.h"
#include "kernel/curves/sampled_pair.h"
#include "kernel/flattening.h"
#include "kernel/nested_paths.h"
#include "kernel/polygon_sum.h"
#include "kernel/snapped_operands.h"
#include "kernel/winding/certain_inside.h"
#include "kernel/winding/winding_faces.h"

namespace blossom::minkowski {
namespace {

CornerNumbers numbersOf(const SampledRegion& region, const Grid& grid) {
  CornerNumbers numbers;
  for (const SampledSide& side : region.sides) numbers.add(grid.nearest(side.from), grid.nearest(side.to));
  return numbers;
}

/// How the polygons of two regions are added.
struct Addition {
  Sampling sampling = Sampling::Chords;
  Inside inside = Inside::Positive;
  const SampledPair* kept = nullptr;  ///< of both, within the tolerances
};

/// The sum of two regions by polygons.
class SampledSum {
 public:
  SampledSum(SampledPair pair, double tolerance, Inside inside, const Progress& progress, Effort& effort)
      : tolerance_(tolerance) {
    const SnappedOperands operands = untangledTogether(pair, progress);
    a_ = std::move(pair.a);
    b_ = std::move(pair.b);
    grid_ = operands.gridOfSum;
    sources_.first = numbersOf(a_, operands.gridA);
    sources_.second = numbersOf(b_, operands.gridB);
    std::optional<CertainInside> certain;
    if (inside == Inside::Positive) certain = certainInside(operands.a, operands.b, Progress(progress.token()));
    edges_ = convolution(operands.a, operands.b, progress.part(0, 0.1), effort, &sources_, certain ? &*certain : nullptr);
    faces_ = tracedFaces(edges_, progress.part(0.1, 0.9), inside, effort);
  }

  /// Nothing when the polygons are too coarse.
  [[nodiscard]] std::optional<Region> curves(const Progress& progress) const {
    const CurveFitting fitting{.rounding = std::max(roundingOf(a_, grid_), roundingOf(b_, grid_)),
                               .reach = 2 * (longestChord(a_) + longestChord(b_)),
                               .gap = 4 * tolerance_};
    const auto curveOf = [&](std::uint32_t edge) { return curveOfEdge(edges_[edge], fitting.rounding); };
    return fittedCurves(faces_, grid_, curveOf, fitting, progress);
  }

  [[nodiscard]] Region lines() const { return straightRegion(faces_, grid_); }

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

Region fittedSum(const SoundRegion& a, const SoundRegion& b, const Addition& addition, const Progress& progress,
                 Effort& effort) {
  const auto attempt = [&](double share, const Progress& part) {
    SampledPair pair = share == 1 && addition.kept ? *addition.kept : sampledPair(a, b, share, addition.sampling, part);
    return SampledSum(std::move(pair), share * (a.tolerance + b.tolerance), addition.inside, part, effort);
  };
  return byFinerPolygons(attempt, progress);
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
  const Box2 boxA = boxOf(flattenedLoops(a)), boxB = boxOf(flattenedLoops(b));
  const Vec2 reach = 2 * boxB.sizes() + boxA.sizes();
  std::vector<Path> paths{framePath(boxA.min() - reach, boxA.max() + reach)};
  for (const Path& loop : a.region.loops) paths.push_back(reversed(loop));
  auto region = nestedPaths(paths, a.tolerance, progress);
  if (!region) return std::nullopt;
  return SoundRegion{*std::move(region), a.tolerance};
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
    return {convexSum(a.region, b.region), tolerance};
  return {fittedSum(a, b, {.kept = kept}, progress, effort), tolerance};
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
