#pragma once
#include "geometry/shape/motion.h"
#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// The point nearest to `wanted` to which these shares of a pull can bring a place: where nothing scales, turning keeps the
/// distance from the trajectory; where nothing turns, scaling goes along the axes of the frame in which p has a component.
/// @param weights the last one above 0 being 1
Vec3 reachableTarget(const Motion&, const MotionPlace&, const PullWeights& weights, const Vec3& wanted);

}  // namespace blossom::sweep
