#pragma once
#include <Eigen/Core>
#include <vector>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Copies of an edit around a motion.
///
/// **Fold n** repeats it at u0 + k (u1 - u0) / n, k = 0 .. n - 1, of a motion that is closed in u with the period u1 - u0.
/// The isometries are the powers of the motion's own rotation from one n-th of the period to the next: the unit quaternion g
/// for which r(u + period / n, v0) = g r(u, v0) at every u. It acts from the left, in space, about an axis through t(v0), so
/// that x(u + period / n, v0) - t = G (x(u, v0) - t) wherever the scaling repeats; for a motion that turns its frame once,
/// G is the n-th part of a full turn. (Acting from the right would turn every copy about the same axis in space.) g is the
/// mean of r(u + period / n, v0) conj(r(u, v0)) over the section v0, its angle made the nearest for which g^n = +-1. On the
/// poles of the functions that an edit changes, this is a shift by rows / n and a multiplication by g, both of which keep
/// lengths: the shortest change that meets copied goals is itself a copy, and a symmetric motion stays symmetric up to
/// rounding, at v0 and wherever g is the same; along a bent path g turns with the frame, and other sections are symmetric
/// only nearly. For that the base knots must repeat; knots that single edits of finer levels added are not among them, and
/// the section is compared as the curve that it is, not row by row.
///
/// **Mirror** adds for each place the one with u reversed over the domain, u0 + u1 - u, which for a closed motion is the
/// reflection over its seam. Its isometry is the reflection F = I - 2 n n^T in the plane through t(v0) for which
/// r(u0 + u1 - u, v0) = n r(u, v0) e, with e the x, y or z axis of the frame and n a unit vector, as quaternions: the mirror
/// image of a frame is a frame once that axis is reversed, which changes nothing where p has no such component, and
/// otherwise needs scalings that change sign. The scaling must be its mirror image as well.
///
/// Both together give the 2 n isometries of a dihedral group.
struct SymmetricPlace {
  MotionPlace at;        ///< inside the domain
  Eigen::Matrix3d turn;  ///< what becomes of vectors from t(v); a rotation or a reflection
};

/// The place itself, first, and its copies. O(n rows). @throws Error InvalidInput with the reason when the base knots or the
/// section do not allow the symmetry; Degenerate when the quaternions of the section vanish.
std::vector<SymmetricPlace> symmetricPlaces(const Motion&, const MotionPlace&, const EditSymmetry&);

/// u inside the period of a motion that is closed in u; of another, u itself.
double insidePeriod(const Motion&, double u);

}  // namespace blossom::sweep
