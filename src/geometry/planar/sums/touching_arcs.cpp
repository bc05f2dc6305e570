#include "geometry/planar/sums/touching_arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/planar/angles.h"

namespace blossom::planar {
namespace {

struct PlacedArc {
  std::size_t loop = 0, segment = 0;
  Arc2 arc;
  std::vector<double> cuts = {};  ///< shares of the sweep
};

/// Where circles touch, one within the other.
std::optional<Vec2> touchFromWithin(const Arc2& a, const Arc2& b) {
  constexpr double rounding = 1e-9;  // of the radius
  const Arc2 &large = a.radius < b.radius ? b : a, &small = a.radius < b.radius ? a : b;
  const Vec2 towards = small.center - large.center;
  const double apart = towards.norm(), within = rounding * large.radius;
  if (apart <= within || std::abs(apart - (large.radius - small.radius)) > within) return std::nullopt;
  return large.center + large.radius / apart * towards;
}

/// The share of the sweep at which an arc passes a point of its circle, if not at an end.
std::optional<double> insideAt(const Arc2& arc, const Vec2& p) {
  constexpr double end = 1e-9;
  const double share = turnAlong(arc, p) / std::abs(arc.sweep);
  return share > end && share < 1 - end ? std::optional(share) : std::nullopt;
}

std::vector<Segment> parts(const PlacedArc& placed) {
  std::vector<double> ends = placed.cuts;
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  ends.push_back(1);
  std::vector<Segment> all;
  double from = 0;
  for (const double to : ends) {
    Arc2 part = placed.arc;
    part.start += from * placed.arc.sweep;
    part.sweep *= to - from;
    all.emplace_back(part);
    from = to;
  }
  return all;
}

}  // namespace

std::optional<Region> dividedWhereArcsTouch(const Region& region, const Progress& progress) {
  std::vector<PlacedArc> arcs;
  for (std::size_t loop = 0; loop < region.loops.size(); ++loop)
    for (std::size_t i = 0; i < region.loops[loop].segments.size(); ++i)
      if (const auto* arc = std::get_if<Arc2>(&region.loops[loop].segments[i])) arcs.push_back({loop, i, *arc});
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    progress.check();
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      if (arcs[i].loop == arcs[j].loop) continue;
      const auto touch = touchFromWithin(arcs[i].arc, arcs[j].arc);
      if (!touch) continue;
      for (PlacedArc* each : {&arcs[i], &arcs[j]})
        if (const auto share = insideAt(each->arc, *touch)) each->cuts.push_back(*share);
    }
  }
  std::erase_if(arcs, [](const PlacedArc& each) { return each.cuts.empty(); });
  if (arcs.empty()) return std::nullopt;
  Region divided = region;
  // Backwards, so that the places of those before stay.
  for (auto each = arcs.rbegin(); each != arcs.rend(); ++each) {
    std::vector<Segment>& segments = divided.loops[each->loop].segments;
    const auto place = segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(each->segment));
    std::vector<Segment> pieces = parts(*each);
    segments.insert(place, pieces.begin(), pieces.end());
  }
  return divided;
}

}  // namespace blossom::planar
