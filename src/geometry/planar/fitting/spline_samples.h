#pragma once
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::planar {

/// A point of a curve and the angle of its normal to the right of the curve.
struct CurveSample {
  Vec2 at;
  double normal = 0;
};

/// Points of each part of a spline from its start to its end, between its kinks: its inflections, chords
/// within the tolerance beside which it runs about as an arc, and all points with one of the normals (0 to 2 pi, sorted)
/// that lie within a chord. A closed spline with a kink at its ends has two parts at least. O(n log n).
std::vector<std::vector<CurveSample>> samplesOf(const Spline2&, double tolerance, const std::vector<double>& normals);

}  // namespace blossom::planar
