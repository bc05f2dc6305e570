#include "kernel/curves/set_sum.h"

#include <algorithm>
#include <utility>

#include "kernel/curves/curved_sum.h"
#include "kernel/curves/finer_polygons.h"
#include "kernel/curves/sampled_sum.h"
#include "kernel/flattening.h"
#include "kernel/sets/complement.h"

namespace blossom::minkowski {
namespace {

Region sweptArea(const SoundSet& a, const SoundSet& b, Sampling sampling, Inside inside, const Progress& progress,
                 Effort& effort) {
  const auto attempt = [&](double share, const Progress& part) {
    return SampledSum(sampledPair(a, b, share, sampling, part), share * (a.tolerance + b.tolerance), inside, part, effort);
  };
  if (isCurved(a) || isCurved(b)) return byFinerPolygons(attempt, progress);
  return attempt(1, progress).lines();
}

/// The curves and points of a set at each of some points.
void addCopies(const SoundSet& set, const std::vector<Vec2>& points, SoundSet& out) {
  for (const Vec2& point : points) {
    const SoundSet copy = translated(set, point);
    out.curves.insert(out.curves.end(), copy.curves.begin(), copy.curves.end());
    out.points.insert(out.points.end(), copy.points.begin(), copy.points.end());
  }
  const auto before = [](const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
  std::sort(out.points.begin(), out.points.end(), before);
  out.points.erase(std::unique(out.points.begin(), out.points.end()), out.points.end());
}

/// Where its loops touch, as those of an earlier result may: by polygons.
SoundRegion complementOf(const SoundRegion& a, const Vec2& size, const Progress& progress, Effort& effort) {
  if (auto around = complement(a, size, progress)) return *std::move(around);
  const Polygons inside = flattened(a.region, {.side = Approximation::Inside, .effort = &effort}, "shape 1", progress);
  return {toRegion(complement(inside, size, progress)), a.tolerance};
}

}  // namespace

SoundSet sum(const SoundSet& a, const SoundSet& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.empty() || b.empty()) return {};
  SoundSet result;
  result.tolerance = a.tolerance + b.tolerance;
  if (a.isArea() && b.isArea()) {
    result.area = sum(a.area, b.area, progress, effort);
    return result;
  }
  if (b.isPoints() && b.points.size() == 1) return translated(a, b.points.front());
  if (a.isPoints() && a.points.size() == 1) return translated(b, a.points.front());
  result.area = {sweptArea(a, b, Sampling::Chords, Inside::Positive, progress, effort), result.tolerance};
  if (b.isPoints())
    addCopies(a, b.points, result);
  else if (a.isPoints())
    addCopies(b, a.points, result);
  return result;
}

SoundRegion difference(const SoundRegion& a, const SoundSet& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (b.isArea()) return difference(a, b.area, progress, effort);
  const double tolerance = a.tolerance + b.tolerance;
  const SoundSet around{complementOf(a, extentOf(b).sizes(), progress, effort), {}, {}, a.tolerance};
  const bool free = isFreeForm(around) || isFreeForm(b);
  const Sampling sampling = free ? Sampling::Chords : Sampling::Around;
  return {sweptArea(around, scaled(b, -1), sampling, Inside::Hollow, progress, effort), tolerance};
}

}  // namespace blossom::minkowski
