#include "kernel/arcs/curved_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/arcs/convex_sum.h"
#include "kernel/arcs/curve_fitting.h"
#include "kernel/arcs/sampled_region.h"
#include "kernel/convolution.h"
#include "kernel/flattening.h"
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
    if (side.arc) longest = std::max(longest, (side.to - side.from).norm());
  return longest;
}

/// How far rounding moves points of a sum and the centres and radii of its arcs.
double roundingOf(const SampledRegion& a, const SampledRegion& b, const Grid& grid) {
  double farthest = 0;
  for (const SampledRegion* region : {&a, &b}) {
    for (const SampledCorner& corner : region->corners) farthest = std::max(farthest, corner.at.cwiseAbs().maxCoeff());
    for (const BoundaryArc& arc : region->arcs)
      farthest = std::max(farthest, arc.centre.cwiseAbs().maxCoeff() + std::abs(arc.radius));
  }
  return 64 * grid.unit + 32 * std::numeric_limits<double>::epsilon() * farthest;
}

/// A sum by polygons within a share of the tolerances.
class SampledSum {
 public:
  /// @param share of the tolerances
  SampledSum(const SoundRegion& a, const SoundRegion& b, double share) : tolerance_(share * (a.tolerance + b.tolerance)) {
    const std::vector<double> normals = endNormals(a.region, b.region);
    a_ = sampled(a.region, normals, share * a.tolerance);
    b_ = sampled(b.region, normals, share * b.tolerance);
  }

  /// Nothing when the polygons are too coarse.
  std::optional<Region> curves(const Progress& progress, Effort& effort) {
    const SnappedOperands operands = snappedTogether(a_.polygons, b_.polygons);
    PairSources sources;
    sources.first = numbersOf(a_, operands.gridA);
    sources.second = numbersOf(b_, operands.gridB);
    const std::vector<CountedEdge> edges = convolution(untangled(operands.a, progress), untangled(operands.b, progress),
                                                       progress.part(0, 0.1), effort, &sources);
    const auto faces = tracedFaces(edges, progress.part(0.1, 0.9), Inside::Positive, effort);
    const Grid& grid = operands.gridOfSum;
    const CurveFitting fitting{
        .rounding = roundingOf(a_, b_, grid), .reach = 2 * (longestChord(a_) + longestChord(b_)), .gap = 4 * tolerance_};
    const auto curveOf = [&](std::uint32_t edge) { return curveOfEdge(edges[edge], sources, grid, fitting.rounding); };
    return fittedCurves(faces, grid, curveOf, fitting, progress);
  }

  /// The sum of the polygons.
  Region lines(const Progress& progress, Effort& effort) {
    return toRegion(sum(a_.polygons, b_.polygons, progress, effort));
  }

 private:
  [[nodiscard]] std::optional<TrueCurve> curveOfEdge(const CountedEdge& edge, const PairSources& sources, const Grid& grid,
                                                     double rounding) const {
    if (edge.source == 0) {
      const auto place = [&](const GridPoint& p) {
        return grid.point(Vec2(static_cast<double>(p.x), static_cast<double>(p.y)));
      };
      return StraightCurve{place(edge.from), place(edge.to)};
    }
    const PairSources::Pair& pair = sources.all[edge.source];
    return pair.edgeOfFirst ? curveOfPair(a_, pair.edge, b_, pair.corner, rounding)
                            : curveOfPair(b_, pair.edge, a_, pair.corner, rounding);
  }

  double tolerance_;
  SampledRegion a_, b_;
};

}  // namespace

SoundRegion sum(const SoundRegion& a, const SoundRegion& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.region.loops.empty() || b.region.loops.empty()) return {};
  const double tolerance = a.tolerance + b.tolerance;
  if (!hasArcs(a.region) && !hasArcs(b.region))
    return {toRegion(sum(toPolygons(a), toPolygons(b), progress, effort)), tolerance};
  if (isConvex(a) && isConvex(b)) return {convexSum(a.region, b.region), tolerance};
  constexpr int attempts = 4;
  constexpr double finer = 1.0 / 8;
  double share = 1;
  for (int i = 0; i < attempts; ++i, share *= finer) {
    progress.check();
    if (auto curves = SampledSum(a, b, share).curves(progress, effort)) return {*std::move(curves), tolerance};
  }
  return {SampledSum(a, b, 1).lines(progress, effort), tolerance};
}

}  // namespace blossom::minkowski
