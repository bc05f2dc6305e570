// The directions in which the curves of two shapes are cut.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/sampled_region.h"
#include "geometry/planar/fitting/spline_samples.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

/// Directions, each once.
class NormalList {
 public:
  void addArcs(const Region& region) {
    forEach<Arc2>(region, [&](const Arc2& arc) {
      add(normalAt(arc, arc.start));
      add(normalAt(arc, arc.start + arc.sweep));
    });
  }
  void addSplines(const SoundRegion& shape, double share) {
    forEach<Spline2>(shape.region, [&](const Spline2& spline) {
      for (const auto& part : samplesOf(spline, share * shape.tolerance, {}))
        for (const CurveSample& sample : part) add(sample.normal);
    });
  }
  void addLines(const Region& region) {
    forEach<Line2>(region, [&](const Line2& line) {
      const Vec2 along = line.to - line.from;
      if (!along.isZero()) add(std::atan2(-along.x(), along.y()));
    });
  }

  std::vector<double> sorted() && {
    std::sort(normals_.begin(), normals_.end());
    const auto end = std::unique(normals_.begin(), normals_.end(), [](double p, double q) { return q - p <= sameAngle; });
    normals_.erase(end, normals_.end());
    while (normals_.size() > 1 && normals_.front() + fullTurn - normals_.back() <= sameAngle) normals_.pop_back();
    return std::move(normals_);
  }

 private:
  template <class Kind, class Visit>
  static void forEach(const Region& region, Visit visit) {
    for (const Path& loop : region.loops)
      for (const Segment& segment : loop.segments)
        if (const auto* each = std::get_if<Kind>(&segment)) visit(*each);
  }
  void add(double normal) { normals_.push_back(inOneTurn(normal)); }

  std::vector<double> normals_;
};

/// About how often the curves of a region turn all around: how often they meet a normal.
double turnsOf(const Region& region) {
  double turns = 0;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      if (const auto* arc = std::get_if<Arc2>(&segment)) turns += std::abs(arc->sweep) / fullTurn;
      if (std::holds_alternative<Spline2>(segment)) turns += 0.5;
    }
  return turns;
}

std::size_t segmentCount(const Region& region) {
  std::size_t count = 0;
  for (const Path& loop : region.loops) count += loop.segments.size();
  return count;
}

}  // namespace

std::vector<double> normalsOf(const SoundRegion& shape, const SoundRegion& other, double share) {
  constexpr std::size_t few = 1000;  // segments
  NormalList normals;
  normals.addArcs(shape.region);
  normals.addSplines(shape, share);
  if (hasSplines(other.region) && segmentCount(shape.region) <= few) normals.addLines(shape.region);
  std::vector<double> all = std::move(normals).sorted();
  constexpr double mostCuts = 20'000;
  if (turnsOf(other.region) * static_cast<double>(all.size()) <= mostCuts) return all;
  return {0, fullTurn / 4, fullTurn / 2, 3 * fullTurn / 4};
}

std::vector<double> normalsOf(const SoundSet& shape, const SoundSet& other, double share) {
  const auto all = [](const SoundSet& set) {
    SoundRegion curves{set.area.region, set.tolerance};
    curves.region.loops.insert(curves.region.loops.end(), set.curves.begin(), set.curves.end());
    return curves;
  };
  std::vector<double> normals = normalsOf(all(shape), all(other), share);
  const std::size_t oneWay = normals.size();
  for (std::size_t i = 0; i < oneWay; ++i) normals.push_back(inOneTurn(normals[i] + std::numbers::pi));
  std::sort(normals.begin(), normals.end());
  const auto same = [](double p, double q) { return q - p <= sameAngle; };
  normals.erase(std::unique(normals.begin(), normals.end(), same), normals.end());
  while (normals.size() > 1 && same(normals.back(), normals.front() + fullTurn)) normals.pop_back();
  return normals;
}

}  // namespace blossom::planar
