#pragma once
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::planar {

/// A point of a curve and the angle of its normal to the right of the curve.
struct CurveSample {
  Vec2 at;
  double normal = 0;
};

/// Points of a spline from its start to its end: its inflections, chords within the tolerance that turn little, and all
/// points with one of the normals (0 to 2 pi, sorted) that lie within a chord. O(n log n).
std::vector<CurveSample> samplesOf(const Spline2&, double tolerance, const std::vector<double>& normals);

}  // namespace blossom::planar
