#include "kernel/curves/sampled_pair.h"

#include <algorithm>
#include <cmath>

#include "kernel/snap_rounding.h"

namespace blossom::minkowski {
namespace {

const double clearShare = std::ldexp(1.0, -30);  // of the size of a shape

double largestSide(const Polygons& polygons) { return boxOf(polygons).sizes().maxCoeff(); }

bool isKnownClear(const SampledRegion& region, const Progress& progress) {
  if (region.polygons.empty()) return false;
  const SnappedOperands snapped = snappedTogether(region.polygons, region.polygons);
  return isClear(snapped.a, progress, clearShare * largestSide(region.polygons) / snapped.gridA.unit);
}

SampledRegion scaled(const SampledRegion& region, double s) {
  SampledRegion image = region;
  for (Polygon& polygon : image.polygons) {
    for (Vec2& p : polygon.outer) p *= s;
    for (Loop& hole : polygon.holes)
      for (Vec2& p : hole) p *= s;
  }
  for (SampledCorner& corner : image.corners) corner.at *= s;
  for (SampledSide& side : image.sides) {
    side.from *= s;
    side.to *= s;
  }
  for (BoundaryCurve& curve : image.curves) {
    curve.centre *= s;
    curve.radius *= s;
  }
  return image;
}

/// Whether what is known to be clear is so by many units of the grid, whatever rounding did.
bool staysClear(bool known, const Polygons& polygons, const Grid& grid) {
  constexpr double manyUnits = 64;
  return known && clearShare * largestSide(polygons) > manyUnits * grid.unit;
}

}  // namespace

SampledPair sampledPair(const SoundRegion& a, const SoundRegion& b, double share, Sampling sampling,
                        const Progress& progress) {
  return {sampled(a, share, normalsOf(b, a, share), sampling, progress),
          sampled(b, share, normalsOf(a, b, share), sampling, progress)};
}

void certifyClear(SampledPair& pair, const Progress& progress) {
  pair.clearA = isKnownClear(pair.a, progress);
  pair.clearB = isKnownClear(pair.b, progress);
}

SampledPair scaled(const SampledPair& pair, double s, double t) {
  return {scaled(pair.a, s), scaled(pair.b, t), pair.clearA, pair.clearB};
}

SnappedOperands untangledTogether(const SampledPair& pair, const Progress& progress) {
  SnappedOperands operands = snappedTogether(pair.a.polygons, pair.b.polygons);
  if (!staysClear(pair.clearA, pair.a.polygons, operands.gridA)) operands.a = untangled(std::move(operands.a), progress);
  if (!staysClear(pair.clearB, pair.b.polygons, operands.gridB)) operands.b = untangled(std::move(operands.b), progress);
  return operands;
}

}  // namespace blossom::minkowski
