#include "geometry/planar/sums/curved_union.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/planar/fitting/curve_fitting.h"
#include "geometry/planar/fitting/finer_polygons.h"
#include "geometry/planar/fitting/sampled_region.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {
namespace {

/// The union of regions by polygons within a share of their tolerances.
class SampledUnion {
 public:
  SampledUnion(std::span<const SoundRegion> regions, double share, const Progress& progress, Effort& effort) {
    Box2 box;
    for (const SoundRegion& region : regions) {
      regions_.push_back(sampled(region, share, {}, Sampling::Chords, progress));
      tolerance_ = std::max(tolerance_, share * region.tolerance);
      for (const SampledCorner& corner : regions_.back().corners) box.extend(corner.at);
    }
    grid_ = {box.center(), gridUnit(box.sizes())};
    for (std::size_t i = 0; i < regions_.size(); ++i) addEdges(i);
    joinEqual(edges_, progress);
    faces_ = tracedFaces(edges_, progress.part(0, 0.9), Inside::Positive, effort);
  }

  /// Nothing when the polygons are too coarse.
  [[nodiscard]] std::optional<Region> curves(const Progress& progress) const {
    double chord = 0, rounding = 0;
    for (const SampledRegion& region : regions_) {
      chord = std::max(chord, longestChord(region));
      rounding = std::max(rounding, roundingOf(region, grid_));
    }
    const auto curveOf = [&](std::uint32_t edge) { return curveOfSide(edges_[edge].source); };
    const double gap = 8 * tolerance_;
    return fittedCurves(faces_, grid_, curveOf, {.rounding = rounding, .reach = 4 * chord, .gap = gap, .closed = gap},
                        progress);
  }

  [[nodiscard]] Region lines() const { return straightRegion(faces_, grid_); }

 private:
  struct Side {
    std::size_t region = 0, side = 0;
  };

  void addEdges(std::size_t i) {
    const std::vector<SampledSide>& sides = regions_[i].sides;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      CountedEdge edge{grid_.nearest(sides[k].from), grid_.nearest(sides[k].to)};
      if (edge.from == edge.to) continue;
      edge.source = static_cast<std::uint32_t>(sides_.size());
      edges_.push_back(edge);
      sides_.push_back({i, k});
    }
  }

  [[nodiscard]] std::optional<TrueCurve> curveOfSide(std::uint32_t source) const {
    const auto [region, number] = sides_[source];
    const SampledSide& side = regions_[region].sides[number];
    if (!side.curve) return StraightCurve{side.from, side.to};
    const BoundaryCurve& curve = regions_[region].curves[*side.curve];
    if (!curve.isFree) return Circle{curve.centre, std::abs(curve.radius)};
    return FreeSide{{*side.curve, region}, {side.from, side.normalFrom}, {side.to, side.normalTo}};
  }

  double tolerance_ = 0;
  std::vector<SampledRegion> regions_;
  Grid grid_;
  std::vector<Side> sides_{{}};  // the first one stands for unknown
  std::vector<CountedEdge> edges_;
  std::vector<TracedPart> faces_;
};

}  // namespace

SoundRegion united(std::span<const SoundRegion> regions, const Progress& progress, Effort& effort) {
  std::vector<SoundRegion> some;
  double tolerance = 0;
  for (const SoundRegion& region : regions)
    if (!region.region.loops.empty()) {
      some.push_back(region);
      tolerance = std::max(tolerance, region.tolerance);
    }
  if (some.empty()) return {};
  if (some.size() == 1) return some.front();
  const auto attempt = [&](double share, const Progress& part) { return SampledUnion(some, share, part, effort); };
  return {byFinerPolygons(attempt, progress), tolerance};
}

}  // namespace blossom::planar
