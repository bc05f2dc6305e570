#pragma once
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/begin/smooth_curve.h"

namespace blossom::sweep {

/// A frame on a curve: tangent, normal and binormal() are perpendicular unit vectors of positive orientation.
struct CurveFrame {
  double at = 0;  ///< parameter of the curve
  Vec3 point, tangent, normal;

  [[nodiscard]] Vec3 binormal() const { return tangent.cross(normal); }
};

struct FrameOptions {
  /// Of the first frame, made perpendicular to the curve; zero: z, or x where the curve starts along z.
  Vec3 normal{0, 0, 0};
  /// Radians over the whole curve: steps are halved until their errors, estimated from halved steps, add up to less. 0: one
  /// step from each parameter to the next.
  double accuracy = 0;
};

struct FrameResult {
  std::vector<CurveFrame> frames;  ///< one for each parameter
  double closing = 0;              ///< radians the last frame was turned by to meet the first one; 0 for open curves
  double uncertainty = 0;          ///< radians, sum of the estimated errors of all steps; 0 without an accuracy
  double length = 0;               ///< mm, of a closed curve; else 0
};

/// One step of the double reflection: the frame mirrored in the plane between the two points, then in the plane between the
/// two tangents (Wang, Juettler, Zheng & Liu 2008, Table I). The error of a step of length h is O(h^5).
CurveFrame doubleReflection(const CurveFrame& from, const CurvePoint& to);

/// Rotation-minimising frames at increasing parameters: their angular velocity has no part along the tangent, so they are
/// at rest on straight pieces and pass inflections. Order 4 in the distance of the parameters (ibid., section 5). On a
/// closed curve, from 0 to 1, the angle by which the last frame misses the first is distributed evenly along the arc
/// length (ibid., section 6.3). Steps that turn by a right angle or more are halved always.
/// @throws Error InvalidParameter for parameters that decrease or a start normal along the tangent; LimitExceeded when the
/// accuracy cannot be reached; Cancelled. O(steps).
FrameResult rotationMinimizingFrames(const SmoothCurve&, std::span<const double> at, const FrameOptions& = {},
                                     const Progress& = Progress::none());

}  // namespace blossom::sweep
