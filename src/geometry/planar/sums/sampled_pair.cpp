#include "geometry/planar/sums/sampled_pair.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/planar/angles.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/snap_rounding.h"

namespace blossom::planar {
namespace {

const double clearShare = std::ldexp(1.0, -30);  // of the size of a shape

double largestSide(const Polygons& polygons) { return boxOf(polygons).sizes().maxCoeff(); }

/// Whether corners that one grid makes the same are so on all grids.
bool agreeExactly(const Polygons& polygons, const Grid& grid) {
  std::vector<std::pair<GridPoint, Vec2>> corners;
  const auto add = [&](const Loop& loop) {
    for (const Vec2& p : loop) corners.emplace_back(grid.nearest(p), p);
  };
  for (const Polygon& polygon : polygons) {
    add(polygon.outer);
    for (const Loop& hole : polygon.holes) add(hole);
  }
  std::sort(corners.begin(), corners.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
  const auto differ = [](const auto& p, const auto& q) { return p.first == q.first && p.second != q.second; };
  return std::adjacent_find(corners.begin(), corners.end(), differ) == corners.end();
}

bool isKnownClear(const SampledRegion& region, const Progress& progress) {
  if (region.polygons.empty()) return false;
  const SnappedOperands snapped = snappedTogether(region.polygons, region.polygons);
  const double units = clearShare * largestSide(region.polygons) / snapped.gridA.unit;
  return isClear(snapped.a, progress, units) ||
         (agreeExactly(region.polygons, snapped.gridA) && touchesInCorners(snapped.a, progress, units));
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

/// A corner of a curve on the grid, and its number along the curve.
struct ThinCorner {
  GridPoint at;
  std::uint32_t along = 0;
};

/// The corners of a curve from its start to its end that differ and turn.
std::vector<ThinCorner> turningCorners(const SampledRegion& region, const ThereAndBack& curve, const Grid& grid) {
  std::vector<ThinCorner> kept;
  for (std::uint32_t k = 0; k <= curve.sides; ++k) {
    const GridPoint p = grid.nearest(region.corners[curve.first + k].at);
    if (!kept.empty() && kept.back().at == p) continue;
    while (kept.size() >= 2) {
      const GridPoint in = kept.back().at - kept[kept.size() - 2].at, out = p - kept.back().at;
      if (cross(in, out) != 0 || dot(in, out) < 0) break;
      kept.pop_back();
    }
    kept.push_back({p, k});
  }
  return kept;
}

/// The longest side of a curve between two of its corners.
std::uint32_t longestSide(const SampledRegion& region, std::uint32_t first, std::uint32_t from, std::uint32_t to) {
  const auto length = [&](std::uint32_t k) { return (region.sides[first + k].to - region.sides[first + k].from).norm(); };
  std::uint32_t longest = from;
  for (std::uint32_t k = from + 1; k < to; ++k)
    if (length(k) > length(longest)) longest = k;
  return longest;
}

GridPolygon thinPoint(const GridPoint& at, std::uint32_t number) { return {{at}, {}, {number}, {CornerNumbers::unknown}}; }

/// There and back along corners that do not fold back.
GridPolygon thinLoop(const SampledRegion& region, const ThereAndBack& curve, std::span<const ThinCorner> corners) {
  GridPolygon loop;
  const std::uint32_t all = 2 * curve.sides;
  const auto add = [&](const ThinCorner& corner, std::uint32_t number, std::uint32_t side) {
    loop.outer.push_back(corner.at);
    loop.cornerNumbers.push_back(curve.first + number % all);
    loop.sideNumbers.push_back(curve.first + side);
  };
  const auto side = [&](std::size_t i) { return longestSide(region, curve.first, corners[i].along, corners[i + 1].along); };
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) add(corners[i], corners[i].along, side(i));
  for (std::size_t i = corners.size() - 1; i > 0; --i) {
    const bool end = i + 1 == corners.size();
    add(corners[i], end ? corners[i].along : all - corners[i].along, all - 1 - side(i - 1));
  }
  return loop;
}

/// Where a curve folds back on itself, each way is a curve of its own: what two of them cover is counted for both.
void addThinLoops(const SampledRegion& region, const ThereAndBack& curve, const Grid& grid, std::vector<GridPolygon>& out) {
  const std::vector<ThinCorner> corners = turningCorners(region, curve, grid);
  if (corners.size() == 1) {
    out.push_back(thinPoint(corners.front().at, curve.first));
    return;
  }
  const std::span<const ThinCorner> all(corners);
  std::size_t begin = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const bool last = i + 1 == corners.size();
    if (!last && cross(corners[i].at - corners[i - 1].at, corners[i + 1].at - corners[i].at) != 0) continue;
    out.push_back(thinLoop(region, curve, all.subspan(begin, i + 1 - begin)));
    begin = i;
  }
}

Box2 boxOfCorners(const SampledRegion& region) {
  Box2 box;
  for (const SampledCorner& corner : region.corners) box.extend(corner.at);
  return box;
}

SnappedOperands snappedWithCurves(const SampledPair& pair, const Progress& progress) {
  const Box2 boxA = boxOfCorners(pair.a), boxB = boxOfCorners(pair.b);
  const Grid gridA{boxA.center(), gridUnit(boxA.sizes().cwiseMax(boxB.sizes()))}, gridB{boxB.center(), gridA.unit};
  const auto onGrid = [&](const SampledRegion& region, const Grid& grid) {
    std::vector<GridPolygon> all;
    if (!region.polygons.empty()) all = untangled(snapped(region.polygons, grid), progress);
    for (const ThereAndBack& curve : region.thin) {
      progress.check();
      addThinLoops(region, curve, grid, all);
    }
    return all;
  };
  return {onGrid(pair.a, gridA), onGrid(pair.b, gridB), gridA, gridB, {gridA.origin + gridB.origin, gridA.unit}};
}

bool isFreeForm(const SoundRegion& shape) { return hasSplines(shape.region); }

std::vector<double> merged(std::vector<double> normals, const std::vector<double>& more) {
  normals.insert(normals.end(), more.begin(), more.end());
  std::sort(normals.begin(), normals.end());
  const auto same = [](double p, double q) { return q - p <= sameAngle; };
  normals.erase(std::unique(normals.begin(), normals.end(), same), normals.end());
  return normals;
}

/// Of the arc whose chords turn least; 0: there are no arcs.
double largestRadius(const std::vector<Path>& paths) {
  double largest = 0;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments)
      if (const auto* arc = std::get_if<Arc2>(&segment)) largest = std::max(largest, std::abs(arc->radius));
  return largest;
}
double largestRadius(const SoundRegion& shape) { return largestRadius(shape.region.loops); }
double largestRadius(const SoundSet& set) { return std::max(largestRadius(set.area), largestRadius(set.curves)); }

/// Directions all around, no farther apart than chords of the arcs turn.
template <class Shape>
std::vector<double> directionsOfChords(const Shape& arcs, double share) {
  constexpr double most = 4096;
  const double step = arcStep(largestRadius(arcs), share * arcs.tolerance);
  const double count = std::min(most, std::ceil(fullTurn / step));
  std::vector<double> directions;
  for (double k = 0; k < count; ++k) directions.push_back(fullTurn * k / count);
  return directions;
}

/// The directions in which curves are cut. In a hollow the sides of arcs are cut away; where a corner of an arc lies between
/// two normals of a spline there, it leaves no point of the spline's sides on the curve.
enum class Cuts {
  Others,  ///< those of the other shape
  Own,     ///< splines also in their own: where two parts turn through the same directions, the other shape has both
  Common,  ///< splines also in their own, and both in directions no farther apart than chords of the arcs turn
};

template <class Shape>
SampledPair sampledTogether(const Shape& a, const Shape& b, double share, Sampling sampling, Cuts kind,
                            const Progress& progress) {
  std::vector<double> cutsOfA = normalsOf(b, a, share), cutsOfB = normalsOf(a, b, share);
  const auto addCuts = [&](const Shape& free, const Shape& other, std::vector<double>& cuts, std::vector<double>& others) {
    if (kind == Cuts::Others || !isFreeForm(free)) return;
    cuts = merged(std::move(cuts), normalsOf(free, free, share));
    if (kind == Cuts::Own || largestRadius(other) == 0) return;
    const std::vector<double> directions = directionsOfChords(other, share);
    cuts = merged(std::move(cuts), directions);
    others = merged(std::move(others), directions);
  };
  addCuts(a, b, cutsOfA, cutsOfB);
  addCuts(b, a, cutsOfB, cutsOfA);
  return {sampled(a, share, cutsOfA, sampling, progress), sampled(b, share, cutsOfB, sampling, progress)};
}

/// Splines no coarser than arcs of the other set: an arc that fits into a hollow turns more at each step.
SoundSet fineBeside(SoundSet set, const SoundSet& other) {
  if (isFreeForm(set) && largestRadius(other) > 0) set.tolerance = std::min(set.tolerance, other.tolerance);
  return set;
}

}  // namespace

SampledPair sampledPair(const SoundSet& a, const SoundSet& b, double share, Sampling sampling, const Progress& progress) {
  return sampledTogether(fineBeside(a, b), fineBeside(b, a), share, sampling, Cuts::Own, progress);
}

SampledPair sampledPair(const SoundRegion& a, const SoundRegion& b, double share, Sampling sampling,
                        const Progress& progress) {
  const bool again = share < 1;  // curves did not fit
  return sampledTogether(a, b, share, sampling, again ? Cuts::Common : Cuts::Others, progress);
}

void certifyClear(SampledPair& pair, const Progress& progress) {
  pair.clearA = isKnownClear(pair.a, progress);
  pair.clearB = isKnownClear(pair.b, progress);
}

SampledPair scaled(const SampledPair& pair, double s, double t) {
  return {scaled(pair.a, s), scaled(pair.b, t), pair.clearA, pair.clearB};
}

SnappedOperands untangledTogether(const SampledPair& pair, const Progress& progress) {
  if (!pair.a.thin.empty() || !pair.b.thin.empty()) return snappedWithCurves(pair, progress);
  SnappedOperands operands = snappedTogether(pair.a.polygons, pair.b.polygons);
  if (!staysClear(pair.clearA, pair.a.polygons, operands.gridA)) operands.a = untangled(std::move(operands.a), progress);
  if (!staysClear(pair.clearB, pair.b.polygons, operands.gridB)) operands.b = untangled(std::move(operands.b), progress);
  return operands;
}

}  // namespace blossom::planar
