#pragma once
#include <optional>

#include "core/vector.h"
#include "kernel/edit/edit_result.h"

namespace blossom::sweep {

/// The rotation of a pull: about a x b by a share of the angle between the vectors a and b, as a unit quaternion
/// (cos th/2, sin th/2 w) (Yoon & Lee 2009, section 4). The axis is made normal to a once more, so that the turned vector
/// points to b up to rounding however nearly opposite the two are.
struct TurnTowards {
  std::optional<Vec4> turn;             ///< none when the vectors do not determine it
  Unreached why = Unreached::Opposite;  ///< then: OnTrajectory (a = 0), TargetOnTrajectory (b = 0), Opposite,
                                        ///< AxisAlongArm
};

/// @param share from 0 to 1  @param axis for opposite vectors, zero when there is none: what of it is normal to a
/// @param smallest length of a vector that has a direction
TurnTowards turnTowards(const Vec3& a, const Vec3& b, double share, const Vec3& axis, double smallest);

}  // namespace blossom::sweep
