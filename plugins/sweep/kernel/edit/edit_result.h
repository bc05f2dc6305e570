#pragma once
#include <string>
#include <vector>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Why a place did not arrive.
enum class Unreached {
  FrameAxis,           ///< p has no component along an axis of the frame along which scaling would have to move it
  Radius,              ///< rotation keeps the distance from the trajectory
  OnTrajectory,        ///< a point on the trajectory cannot rotate
  TargetOnTrajectory,  ///< no direction leads from the trajectory to the target
  Opposite,            ///< half a turn, without an axis for it
  AxisAlongArm,        ///< half a turn, and the axis for it points along the line from the trajectory to the point
  Cancelled,           ///< the basis functions of a closed motion cancel each other there
  TooClose,            ///< places ask for more than their common poles can do
  Pinned,              ///< the same, and pins hold some of these poles
  Symmetry,            ///< the same, and the places are copies of one
  TwoTargets,          ///< two places of the edit are one, with a target each
};

struct Obstacle {
  Unreached why;
  MotionPlace at;  ///< of the edit, not of its copy
  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// What a user reads of it, as two sentences.
struct Explanation {
  std::string what, remedy;
};
Explanation explain(const Obstacle&);
/// The swing of an edit above which its surface goes far astray between the places that arrive.
constexpr double wildSwing = 20;
Explanation explainSwing(double swing);

/// A motion after an edit.
struct EditResult {
  Motion motion;
  /// For each place the largest distance that is left for it or its copies: mm after a pull, degrees after a twist.
  std::vector<double> remainders;
  double remainder = 0;        ///< the largest of these
  std::size_t movedPoles = 0;  ///< poles of the three factors that are other than before
  /// How many times as far some pole of a factor moves as any place asks that shares poles with it, directly or over others
  /// and pins; 1 to 4 for one place alone.
  double swing = 0;
  std::vector<Obstacle> obstacles;  ///< of the places that did not arrive; empty when all did
};

}  // namespace blossom::sweep
