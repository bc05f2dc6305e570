#include "geometry/planar/sums/loop_senses.h"

#include <algorithm>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/segment_point.h"

namespace blossom::planar {
namespace {

/// Off the ends of its segments, where others may touch it.
Vec2 placeOn(const Path& loop) {
  const auto extent = [](const Segment& segment) { return boxAround(segment).sizes().norm(); };
  return middleOf(*std::max_element(loop.segments.begin(), loop.segments.end(),
                                    [&](const Segment& a, const Segment& b) { return extent(a) < extent(b); }));
}

}  // namespace

LoopSenses::LoopSenses(const std::vector<Path>& loops, const Progress& progress) : all_(Region{loops}, progress) {
  double area = 0;
  for (const Path& loop : loops) area += signedArea(loop);
  inward_ = area < 0 ? -1 : 1;
}

bool LoopSenses::holds(const Vec2& place) const { return inward_ * all_.windingNumber(place) == 1; }

// A place on the loop itself counts it with one side or the other; what counts is what the other loops make of it.
bool LoopSenses::bounds(const Path& loop) const {
  const Vec2 place = placeOn(loop);
  const int ofOthers = all_.windingNumber(place) - BoundaryTree(Region{{loop}}).windingNumber(place);
  const bool isAroundArea = inward_ * signedArea(loop) > 0;
  return inward_ * ofOthers == (isAroundArea ? 0 : 1);
}

}  // namespace blossom::planar
