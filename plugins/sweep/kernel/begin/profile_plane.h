#pragma once
#include <string>

#include "geometry/bspline/curve.h"

namespace blossom::sweep {

/// The plane of a profile: a place in it and two perpendicular directions of unit length.
struct ProfilePlane {
  Vec3 origin, x, y;
};

/// @throws Error InvalidInput "The profile cannot be used: .." with a reason and what to do.
[[noreturn]] void refuseProfile(const std::string& why, const std::string& hint);

/// The plane of a closed curve. Its normal is that of the vector area (Newell), half the sum of the cross products of points
/// along the curve, turned upward; x is the projection of the x axis, or of the y axis where the plane is square to x.
/// @throws Error InvalidInput when no area is enclosed or a pole leaves the plane by 1e-7 of the size. O(poles).
ProfilePlane profilePlane(const Curve&);

/// The curve in coordinates of the plane about a place, z = 0.
Curve flattened(const Curve&, const ProfilePlane&, const Vec3& about);

/// Integrals of x dy - y dx times 1, x and y along a flat closed curve: twice the area and three times its first moments
/// (Green). Gauss's rule of 24 nodes on each span.
Vec3 areaAndMoments(const Curve& flat);

}  // namespace blossom::sweep
