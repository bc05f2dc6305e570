#include "geometry/planar/sums/set_sum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/planar/fitting/finer_polygons.h"
#include "geometry/planar/sums/complement.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/sampled_sum.h"

namespace blossom::planar {
namespace {

Region sweptArea(const SoundSet& a, const SoundSet& b, Sampling sampling, Inside inside, const Progress& progress,
                 Effort& effort) {
  const auto attempt = [&](double share, const Progress& part) {
    return SampledSum(sampledPair(a, b, share, sampling, part), share * (a.tolerance + b.tolerance), inside, part, effort);
  };
  if (isCurved(a) || isCurved(b)) return byFinerPolygons(attempt, progress);
  return attempt(1, progress).lines();
}

void sortPoints(std::vector<Vec2>& points) {
  std::sort(points.begin(), points.end(), fartherLeft);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// The curves and points of a set at each of some points.
void addCopies(const SoundSet& set, const std::vector<Vec2>& points, SoundSet& out, const Progress& progress,
               Effort& effort) {
  for (const Vec2& point : points) {
    progress.check();
    effort.spend(set.curves.size() + set.points.size());
    const SoundSet copy = translated(set, point);
    out.curves.insert(out.curves.end(), copy.curves.begin(), copy.curves.end());
    out.points.insert(out.points.end(), copy.points.begin(), copy.points.end());
  }
}

std::vector<Line2> linesOf(const SoundSet& set) {
  std::vector<Line2> lines;
  for (const Path& curve : set.curves)
    for (const Segment& segment : curve.segments)
      if (const auto* line = std::get_if<Line2>(&segment)) lines.push_back(*line);
  return lines;
}

/// Of parallel lines, which is one as long as both.
Line2 sumOfParallels(const Line2& a, const Line2& b) {
  const bool alike = (a.to - a.from).dot(b.to - b.from) > 0;
  return {a.from + (alike ? b.from : b.to), a.to + (alike ? b.to : b.from)};
}

bool areParallel(const Line2& a, const Line2& b) {
  constexpr double rounding = 1e-12;  // of directions, by which corners of scaled and moved lines are off
  const Vec2 along = a.to - a.from, other = b.to - b.from;
  return std::abs(cross(along, other)) <= rounding * along.norm() * other.norm();
}

void addSumsOfParallels(const SoundSet& a, const SoundSet& b, SoundSet& out, const Progress& progress, Effort& effort) {
  const std::vector<Line2> lines = linesOf(b);
  for (const Line2& one : linesOf(a)) {
    progress.check();
    effort.spend(lines.size());
    for (const Line2& other : lines)
      if (areParallel(one, other)) out.curves.push_back({{sumOfParallels(one, other)}, false, {}, {}});
  }
}

/// By lines on the safe side: the curves of B run within its tolerance of their chords, so the complement is grown by that.
SoundRegion differenceByLines(const SoundRegion& a, const SoundSet& b, const Progress& progress, Effort& effort) {
  const Polygons inside = polygonsBeside(a, Approximation::Inside, "shape 1", progress, effort);
  if (inside.empty()) return {};
  Polygons around = complement(inside, extentOf(b).sizes(), progress);
  if (isCurved(b)) around = grownBy(around, b.tolerance, progress.part(0, 0.3), effort);
  const SoundSet outside{{toRegion(around), a.tolerance}, {}, {}, a.tolerance};
  const SampledPair pair = sampledPair(outside, scaled(b, -1), 1, Sampling::Chords, progress);
  const double tolerance = a.tolerance + b.tolerance;
  return {SampledSum(pair, tolerance, Inside::Hollow, progress.part(0.3, 1), effort).lines(), tolerance,
          !isFreeForm(b) && !hasSplines(a.region)};
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
  if (a.isPoints() || b.isPoints()) addThinSum(a, b, result, progress, effort);
  return result;
}

void addThinSum(const SoundSet& a, const SoundSet& b, SoundSet& out, const Progress& progress, Effort& effort) {
  addSumsOfParallels(a, b, out, progress, effort);
  addCopies(a, b.points, out, progress, effort);
  addCopies({{}, b.curves, {}, b.tolerance}, a.points, out, progress, effort);
  sortPoints(out.points);
}

SoundRegion difference(const SoundRegion& a, const SoundSet& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.region.loops.empty()) return {};
  if (b.isArea()) return difference(a, b.area, progress, effort);
  if (b.isPoints() && b.points.size() == 1) return translated(a, -b.points.front());
  if (!isFreeForm(b) && !hasSplines(a.region))
    if (auto around = complement(a, extentOf(b).sizes(), progress)) {
      const SoundSet outside{*std::move(around), {}, {}, a.tolerance};
      return {sweptArea(outside, scaled(b, -1), Sampling::Around, Inside::Hollow, progress, effort),
              a.tolerance + b.tolerance};
    }
  return differenceByLines(a, b, progress, effort);
}

}  // namespace blossom::planar
