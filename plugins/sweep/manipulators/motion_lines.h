#pragma once
#include <array>
#include <vector>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Lines that show a motion beside the surface it sweeps. The edits of the motion have been applied.

using Polylines = std::vector<std::vector<Vec3>>;

/// The axes of frames M(u, v) where they carry the point: from x(u, v) along the axes of the moving frame, each as long as
/// its factor of the scaling, the longest of all as long as `length`. One list for each of the axes x, y and z.
/// @param countU,countV at least 2; of a motion that is closed in u, countU places around
std::array<Polylines, 3> frameLines(const Motion&, std::size_t countU, std::size_t countV, double length);

/// The curves x(u, .) and x(., v) at the knots of the factors, the ends of the surface included.
Polylines knotCurves(const Motion&);

/// The curvature comb of the trajectory: teeth away from the centre of curvature, the longest `length`, and the line
/// through their ends. Empty where nothing bends.
Polylines trajectoryCombLines(const Motion&, double length);

/// A length that suits frames: a share of how far the point swings about the trajectory.
double suitableAxis(const Motion&);

}  // namespace blossom::sweep
