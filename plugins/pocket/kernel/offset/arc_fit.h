#pragma once
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// A point of a curve with its unit tangent.
struct TangentPoint {
  Vec2 at, tangent;
};

/// The arc from a to b that sweeps `sweep` radians (a line when the sweep is close to 0).
Segment arcBetween(const Vec2& a, const Vec2& b, double sweep);

/// Lines and arcs from the first sample to the last, within `tolerance` mm of all samples: biarcs through as few samples as
/// possible (Bolton, "Biarc curves", CAD 7(2), 1975; the joint with equal control lengths). O(n log n).
std::vector<Segment> fittedArcs(const std::vector<TangentPoint>& samples, double tolerance);

}  // namespace blossom::pocket
