#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/bspline/spline_space.h"
#include "geometry/shape/motion.h"
#include "kernel/edit/least_change.h"
#include "kernel/edit/place_row.h"

namespace blossom::sweep {

/// How the ends in v of a factor belong together in a motion that closes in v, as a torus or a tube along a closed curve.
struct JoinedEnds {
  double ratio = 1;    ///< of the value at the end to that at the start; -1 for quaternions after a full turn
  int continuity = 0;  ///< so many derivatives in v are in the same ratio; degree - 1 at most
};

/// Factors are clamped in v, so nothing in their form tells that a motion closes there: it does when the end of each factor
/// is a fixed multiple of its start, within 1e-9 of what the poles of the factor differ by, and something changes in
/// between.
struct JoinedFactors {
  JoinedEnds trajectory, orientation, scaling;
};
/// Empty when the motion does not close in v. O(poles).
std::optional<JoinedFactors> joinedInV(const Motion&);

/// With continuity k, a factor of degree p whose ends are joined is a periodic spline with a knot of multiplicity p - k at
/// the seam. This is the space in v of that spline; its closure is the ratio.
SplineSpace ringSpace(const SplineSpace& clamped, const JoinedEnds&);

/// Keeps the ends in v of one factor together while its poles change. Only the poles of the periodic spline that it is are
/// free, so that a change is the same wherever around the ring it is made. Free poles away from the seam are
/// clamped poles, with the same numbers bit for bit; k + 1 fewer are free than stand in the factor.
///
/// The poles of a trajectory are Euclidean here; free ones count with the weight that they have as rational poles, and
/// where such a weight would not be positive, with the smallest weight of the trajectory.
class SeamV {
 public:
  /// Of a factor that is open in v: every pole is free.
  SeamV() = default;
  SeamV(const Curve& trajectory, const JoinedEnds&);
  /// @param clamped space in v of an orientation or a scaling
  SeamV(const SplineSpace& clamped, const JoinedEnds&);

  /// None: open.
  [[nodiscard]] const std::optional<JoinedEnds>& ends() const { return ends_; }

  /// What each free pole contributes, from what each pole does. Free poles are numbered as poles are, row by row.
  [[nodiscard]] PlaceRow onFreePoles(const PlaceRow&) const;
  /// The change of all poles by that of the free ones.
  [[nodiscard]] PoleChange onAllPoles(const PoleChange&) const;
  /// The poles along v from the coefficients of the functions of the ring. @pre not open  @param ring ringSpace of the
  /// factor; of a trajectory, whose Euclidean poles come back whatever the ratio of the rational ones is, with closure 1
  [[nodiscard]] SpaceMap fromFunctions(const SplineSpace& ring) const;

 private:
  struct Share {
    std::size_t pole;  ///< its place in v
    double share;
  };
  void assign(std::vector<std::vector<Share>> freeOfPole);

  std::optional<JoinedEnds> ends_;
  std::vector<std::vector<Share>> freeOfPole_, polesOfFree_;  ///< empty: open
};

/// The seams of the three factors; of an open motion, open ones.
struct MotionSeams {
  SeamV trajectory, orientation, scaling;
};
MotionSeams seamsInV(const Motion&);

}  // namespace blossom::sweep
