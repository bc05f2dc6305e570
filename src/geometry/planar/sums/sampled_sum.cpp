#include "geometry/planar/sums/sampled_sum.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/planar/fitting/curve_fitting.h"
#include "geometry/planar/polygons/snapped_operands.h"
#include "geometry/planar/winding/edges_of_sum.h"

namespace blossom::planar {
namespace {

/// Curves and points beside the area come last and carry their numbers themselves.
CornerNumbers numbersOf(const SampledRegion& region, const Grid& grid) {
  const std::size_t ofArea = region.thin.empty() ? region.sides.size() : region.thin.front().first;
  CornerNumbers numbers;
  for (std::size_t i = 0; i < ofArea; ++i) numbers.add(grid.nearest(region.sides[i].from), grid.nearest(region.sides[i].to));
  return numbers;
}

}  // namespace

SampledSum::SampledSum(SampledPair pair, double tolerance, Inside inside, const Progress& progress, Effort& effort)
    : tolerance_(tolerance), inside_(inside) {
  const SnappedOperands operands = untangledTogether(pair, progress);
  a_ = std::move(pair.a);
  b_ = std::move(pair.b);
  grid_ = operands.gridOfSum;
  sources_.first = numbersOf(a_, operands.gridA);
  sources_.second = numbersOf(b_, operands.gridB);
  edges_ = edgesOfSum(operands.a, operands.b, inside, progress.part(0, 0.1), effort, &sources_);
  faces_ = tracedFaces(edges_, progress.part(0.1, 0.9), inside, effort);
}

// A ring of room between two arcs would fall to pieces where their polygons meet.
std::optional<Region> SampledSum::curves(const Progress& progress) const {
  return curvesClosing(inside_ == Inside::Hollow ? 0 : largestGap(), progress);
}

std::optional<Region> SampledSum::curvesInPieces(const Progress& progress) const {
  if (inside_ != Inside::Hollow) return std::nullopt;
  return curvesClosing(largestGap(), progress);
}

std::optional<Region> SampledSum::curvesClosing(double closed, const Progress& progress) const {
  const CurveFitting fitting{.rounding = std::max(roundingOf(a_, grid_), roundingOf(b_, grid_)),
                             .reach = 2 * (longestChord(a_) + longestChord(b_)),
                             .gap = largestGap(),
                             .closed = closed};
  const auto curveOf = [&](std::uint32_t edge) { return curveOfEdge(edges_[edge], fitting.rounding); };
  return fittedCurves(faces_, grid_, curveOf, fitting, progress);
}

Region SampledSum::lines() const { return straightRegion(faces_, grid_); }

std::optional<TrueCurve> SampledSum::curveOfEdge(const CountedEdge& edge, double rounding) const {
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

}  // namespace blossom::planar
