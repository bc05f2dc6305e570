#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// A pole of orientation or scaling: its row along u and its column along v, counted from 0 as in a motion file. The rows
/// that a closed motion repeats are none of their own.
struct FactorPole {
  std::size_t row = 0, column = 0;
  friend auto operator<=>(const FactorPole&, const FactorPole&) = default;  // NOLINT(modernize-use-nullptr)
};

/// A pole of the trajectory in space; its weight stays.
struct TrajectoryMove {
  std::size_t pole = 0;
  bool absolute = false;  ///< placed at `vector`, not moved by it
  Vec3 vector{0, 0, 0};   ///< mm
  friend bool operator==(const TrajectoryMove&, const TrajectoryMove&) = default;
};

/// The weight of a pole of the trajectory; its place stays.
struct TrajectoryWeight {
  std::size_t pole = 0;
  double weight = 1;
  friend bool operator==(const TrajectoryWeight&, const TrajectoryWeight&) = default;
};

/// A quaternion of the orientation turned by dq, r -> dq r, about an axis in space; its length stays. Absolute: it becomes
/// the turn itself, with the sign nearer to the one before, because q and -q are the same rotation but not the same pole.
struct OrientationTurn {
  FactorPole pole;
  bool absolute = false;
  Vec3 axis{0, 0, 1};  ///< of any length but 0, unless the angle is 0
  double angle = 0;    ///< degrees, at most one full turn
  friend bool operator==(const OrientationTurn&, const OrientationTurn&) = default;
};

/// The factors (sx, sy, sz) / sw of a pole of the scaling, multiplied by others or, absolute, set; and its weight sw
/// multiplied, with factors that stay.
struct ScalingChange {
  FactorPole pole;
  bool absolute = false;
  Vec3 factors{1, 1, 1};
  double weight = 1;
  friend bool operator==(const ScalingChange&, const ScalingChange&) = default;
};

/// Changes of single poles of the three factors of a motion. Those in one list are made in order; the lists concern
/// different numbers, so that their order does not matter.
struct FactorChanges {
  std::vector<TrajectoryMove> trajectory = {};
  std::vector<TrajectoryWeight> weights = {};
  std::vector<OrientationTurn> orientation = {};
  std::vector<ScalingChange> scaling = {};
  [[nodiscard]] bool empty() const;
  friend bool operator==(const FactorChanges&, const FactorChanges&) = default;
};

struct FactorChangeResult {
  Motion motion;
  std::size_t changedPoles = 0;  ///< that are other than before, rows repeated by a closed motion not counted
};

/// The motion with these changes; the rows that a closed motion repeats follow. Poles that no change names stay to the last
/// bit, and a change has influence over the support of its pole alone: degree + 1 spans in each direction. Edits that the
/// motion keeps (Motion::edits) are neither applied nor lost. O(poles + changes), and the proof of `requireNonVanishing`
/// when an orientation changes.
/// @throws Error InvalidParameter naming the change ("scaling[2]") and its pole for a pole that does not exist, a number
/// that is not finite, an axis without length, an angle beyond a full turn, a weight that is not above 0; Degenerate naming
/// (u, v) where the orientation comes to vanish; Cancelled.
FactorChangeResult withChangedFactors(const Motion&, const FactorChanges&, const Progress& = Progress::none());

/// One list that does what two do one after the other: changes of the same pole that can be said as one become one.
FactorChanges followedBy(FactorChanges first, const FactorChanges& second);

/// Rows of a factor that are not repetitions of others.
std::size_t freeRows(const Motion&, const Surface& factor);

}  // namespace blossom::sweep
