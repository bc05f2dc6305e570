#pragma once
#include <span>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/triangle_distance.h"

/// Figures of triangles that together enclose a volume, oriented counter-clockwise seen from outside.
namespace blossom {

/// How often the triangles turn around a point that does not lie on them: the sum of their signed solid angles over 4 pi
/// (Van Oosterom & Strackee 1983). An integer up to rounding. O(n). @throws Error Cancelled.
double windingNumber(std::span<const Triangle3>, const Vec3& point, const Progress& = Progress::none());

/// Below 0 when they look inwards. Summed from the first corner, so that places far away cost no digits. O(n).
double signedVolume(std::span<const Triangle3>);

/// Two points close to a place inside the largest triangle, before and behind it: off the triangles, so that winding numbers
/// there are integers even where other triangles touch these. O(n). @pre not empty
struct PointsBeside {
  Vec3 front = Vec3::Zero(), back = Vec3::Zero();
};
PointsBeside pointsBesideLargest(std::span<const Triangle3>);

}  // namespace blossom
