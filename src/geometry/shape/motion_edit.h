#pragma once
#include <variant>
#include <vector>

#include "core/vector.h"

/// Changes of a two-parameter motion by direct manipulation, as values (Yoon & Lee 2009, section 4). What they do is decided
/// where they are applied, by the plugin of sweeps; here they are data: read, written, compared and passed on.
namespace blossom {

/// Parameters of a place on the swept surface. In a motion that is closed in u, u may lie outside the period.
struct MotionPlace {
  double u = 0, v = 0;
  friend bool operator==(const MotionPlace&, const MotionPlace&) = default;
};

/// The shares of a pull, each from 0 to 1: a fraction of what is left when its turn comes, in the order translate, rotate,
/// scale. The last one above 0 counts as 1.
struct PullWeights {
  double translate = 0, rotate = 1, scale = 1;
  friend bool operator==(const PullWeights&, const PullWeights&) = default;
};

/// How often an edit is repeated around a motion that is closed in u.
struct EditSymmetry {
  int fold = 1;         ///< places at even distances in u; 1: no repetition
  bool mirror = false;  ///< each place once more with u reversed
  friend bool operator==(const EditSymmetry&, const EditSymmetry&) = default;
};

/// How wide a part an edit changes: the functions by which it does reach over degree + 1 spans. Level 0: the spans of the
/// motion's base knots; n: each of them halved n times, where the edit needs it; -n: n times every second knot left out, as
/// far as there are some.
inline constexpr int coarsestLevel = -8, finestLevel = 8;

/// Moves points of the swept surface to their targets.
struct MotionPull {
  std::vector<MotionPlace> at;
  std::vector<Vec3> to;  ///< mm, one for each place
  PullWeights weights = {};
  Vec3 axis = Vec3::Zero();            ///< for a rotation by half a turn, which has none of its own; zero: not given
  std::vector<MotionPlace> pins = {};  ///< places that stay where they are
  EditSymmetry symmetry = {};
  int level = 0;  ///< coarsestLevel .. finestLevel
  friend bool operator==(const MotionPull&, const MotionPull&) = default;
};

/// Turns the moving frame at some places about an axis in space through the trajectory there.
struct MotionTwist {
  std::vector<MotionPlace> at;
  Vec3 axis = Vec3::UnitZ();  ///< of any length but 0
  double angle = 0;           ///< degrees, at most one full turn
  std::vector<MotionPlace> pins = {};
  EditSymmetry symmetry = {};
  int level = 0;  ///< coarsestLevel .. finestLevel
  friend bool operator==(const MotionTwist&, const MotionTwist&) = default;
};

using MotionEdit = std::variant<MotionPull, MotionTwist>;

}  // namespace blossom
