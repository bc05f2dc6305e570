#pragma once
#include "core/progress.h"
#include "geometry/shape/motion.h"
#include "kernel/edit/edit_result.h"

namespace blossom::sweep {

/// Turns the moving frame at some places by an angle about an axis in space through t(v); the frames around follow (Yoon &
/// Lee 2009, section 4 and Fig. 7 e, f). A point off the axis moves on a circle about it; a point on the axis stays, and the
/// surface around it is twisted. The orientation changes by dq * r - r at each place, by the smallest change of its poles
/// (kernel/edit/least_change.h); the quaternion keeps its length there. Copies of a symmetric twist turn about the axis
/// carried along (kernel/edit/motion_symmetry.h), mirrored ones the other way round. `remainders` are degrees.
///
/// A full turn takes r to -r, which is the same rotation: the nearer an angle is to it, the nearer to zero the quaternions
/// around come. Two twists at the same places and level are one by both angles, as the change of the poles depends on r
/// before and after alone; half of the angle at a coarser level and half at a finer one turn from pole to pole by less.
/// Complexity and errors as of `pull`; InvalidParameter also for an axis of length 0 and an angle beyond one full turn;
/// Degenerate, with the place, when the orientation would vanish somewhere where it did not.
EditResult twist(const Motion&, const MotionTwist&, const Progress& = Progress::none());

}  // namespace blossom::sweep
