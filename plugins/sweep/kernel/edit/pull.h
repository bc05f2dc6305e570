#pragma once
#include "core/progress.h"
#include "geometry/shape/motion.h"
#include "kernel/edit/edit_result.h"

namespace blossom::sweep {

/// Direct manipulation of a swept surface: its points x(u, v) go to targets p' (Yoon & Lee 2009, section 4).
///
/// The displacement is split by the shares of the edit, each a fraction of what is left when its turn comes:
/// - **translate** moves the trajectory t(v) by that fraction of p' - x;
/// - **rotate** turns the frame by that fraction of the angle from x - t to p' - t, about their common normal: the
///   orientation, of any length, changes by dq * r - r (the paper's change of unit quaternions misses unless |r| = 1);
/// - **scale** moves the point by that fraction of the vector left: with y = Q(r)^T (p' - t) / |r|^2 the factors become
///   s_i = s_w y_i / p_i.
/// The last share above 0 counts as 1, so that the point arrives where that factor can bring it there. Everything is
/// computed from the motion given, in closed form; nothing is iterated. Each factor takes the change of its poles that is
/// the smallest (kernel/edit/least_change.h); weights stay, and so does every pole whose basis function is 0 at all places,
/// copies and pins. Several places are moved together, and symmetric edits are edits of several places
/// (kernel/edit/motion_symmetry.h): a trajectory, which all copies share, takes the mean of what they want. A motion that
/// closes in v stays closed there, as smooth as it is (kernel/edit/seam_v.h).
///
/// A place has arrived when it is left by at most 1e-9 of the distances from the trajectory, of places and targets, which
/// allows for rounding where basis functions nearly cancel each other, or by 1e-13 of their coordinates, which allows for
/// rounding far from the origin; most arrive within 1e-15 of these. Edits that the motion keeps (Motion::edits) are
/// neither applied nor lost. O(degree^2) for one place, else that of leastChange. @throws Error InvalidParameter for sizes
/// that do not match, shares outside 0 .. 1 or all 0, values that are not finite, places outside; InvalidInput when the
/// motion has not the symmetry; LimitExceeded; Degenerate; Cancelled.
EditResult pull(const Motion&, const MotionPull&, const Progress& = Progress::none());

}  // namespace blossom::sweep
