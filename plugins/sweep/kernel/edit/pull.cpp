#include "kernel/edit/pull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/edit/edit_places.h"
#include "kernel/edit/turn_towards.h"
#include "kernel/grid/motion_point.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

/// A place has arrived when no more than these shares are left: of the distances that turn and scale, and of the
/// coordinates, which have no finer steps. Far from the origin the second alone would let a small pull fall short unnoticed
/// if it were as large as the first.
constexpr double arrived = 1e-9, arrivedOfPlace = 1e-13;
/// What is left of the way, as a share of the coordinates, when no factor has anything to do: rounding would be taken for a
/// wish, and be answered by knots and poles far away.
constexpr double settled = 1e-14;
/// A component of p below this share of the others is none.
constexpr double noComponent = 1e-9;

void checkPull(const MotionPull& p) {
  const auto refuse = [](const std::string& message) { throw Error(ErrorCode::InvalidParameter, message); };
  if (p.to.size() != p.at.size())
    refuse(fmt::format("A pull needs a target for each of its {} places; it has {}.", p.at.size(), p.to.size()));
  for (const Vec3& to : p.to)
    if (!to.allFinite()) refuse("The target of a pull must be finite numbers.");
  if (!p.axis.allFinite()) refuse("The axis of a pull must be finite numbers.");
  for (const double share : {p.weights.translate, p.weights.rotate, p.weights.scale})
    if (!(share >= 0 && share <= 1)) refuse(fmt::format("Shares of a pull lie between 0 and 1; one is {}.", share));
  if (p.weights == PullWeights{0, 0, 0})
    refuse("A pull must translate, rotate or scale: one of these shares must be above 0.");
}

/// The last share above 0 made 1.
PullWeights withLastWhole(PullWeights weights) {
  for (double* share : {&weights.scale, &weights.rotate, &weights.translate})
    if (*share > 0) {
      *share = 1;
      break;
    }
  return weights;
}

class Pull {
 public:
  Pull(const Motion& motion, const MotionPull& options, const Progress& progress)
      : edit_(motion, options.at, options.pins, options.symmetry, options.level, progress), axis_(options.axis) {
    for (const Vec4& pole : motion.trajectory.poles) size_ = std::max(size_, pole.head<3>().norm() / pole[3]);
    for (const EditPlace& place : edit_.places()) {
      const Vec3 centre = centreAt(place);
      to_.push_back(centre + place.turn * (options.to[place.of] - originOf(motion, options.at[place.of])));
      const Vec3 x = pointAt(place);
      size_ = std::max({size_, centre.norm(), to_.back().norm(), x.norm()});
      reach_ = std::max({reach_, (to_.back() - centre).norm(), (x - centre).norm()});
    }
    edit_.markContradictions([&](std::size_t i, std::size_t j) { return (to_[i] - to_[j]).norm() > allowed(); });
  }

  void translate(double share) {
    edit_.changeTrajectory([&](const EditPlace& place) -> Vec3 {
      if (isSettled(place)) return Vec3::Zero();
      return share * (toOf(place) - pointAt(place));
    });
  }

  void rotate(double share) {
    edit_.changeOrientation([&](EditPlace& place) -> Vec4 {
      if (isSettled(place)) return Vec4::Zero();
      const Vec3 centre = centreAt(place);
      // Half a turn about a copied axis; reflections turn the other way about the reflected one.
      const Vec3 axis = place.turn.determinant() * (place.turn * axis_);
      const TurnTowards turn = turnTowards(armAt(place), toOf(place) - centre, share, axis, 1e-13 * size_);
      if (!turn.turn) {
        place.obstacles.push_back(turn.why);
        return Vec4::Zero();
      }
      const Vec4 r = evaluate(edit_.motion().orientation, place.at.u, place.at.v);
      return times(*turn.turn, r) - r;
    });
  }

  /// @param turnedFully rotation has done all it can: where it could turn a place, poles that others share are to blame for
  /// the direction that is left, not the axes of the frame
  void scale(double share, bool turnedFully) {
    edit_.changeScaling([&](EditPlace& place) -> Vec4 {
      if (isSettled(place)) return Vec4::Zero();
      const bool couldTurn = turnedFully && place.obstacles.empty();
      const Motion& motion = edit_.motion();
      const Vec3 x = pointAt(place), to = x + share * (toOf(place) - x) - centreAt(place);
      const Vec4 s = evaluate(motion.scaling, place.at.u, place.at.v);
      const Vec3 y = turnedBack(evaluate(motion.orientation, place.at.u, place.at.v), to);
      Vec4 change = Vec4::Zero();
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (std::abs(motion.point[k]) > noComponent * motion.point.cwiseAbs().maxCoeff())
          change[k] = s[3] * y[k] / motion.point[k] - s[k];
        else if (std::abs(y[k]) > allowed() && !couldTurn)
          addOnce(place, Unreached::FrameAxis);
      }
      return change;
    });
  }

  EditResult finished(bool byRotation) {
    return edit_.finished([&](const EditPlace& place) { return (toOf(place) - pointAt(place)).norm(); }, allowed(),
                          byRotation ? Unreached::Radius : Unreached::TooClose);
  }

 private:
  /// What may be left, mm.
  [[nodiscard]] double allowed() const { return std::max(arrived * reach_, arrivedOfPlace * size_); }
  [[nodiscard]] bool isSettled(const EditPlace& place) const {
    return (toOf(place) - pointAt(place)).norm() <= settled * size_;
  }
  static void addOnce(EditPlace& place, Unreached why) {
    if (place.obstacles.empty() || place.obstacles.back() != why) place.obstacles.push_back(why);
  }
  static Vec3 originOf(const Motion& motion, const MotionPlace& at) { return blossom::point(motion.trajectory, at.v); }
  [[nodiscard]] Vec3 centreAt(const EditPlace& place) const { return originOf(edit_.motion(), place.at); }
  /// x - t from the factors, for the difference of two points near each other has lost its direction.
  [[nodiscard]] Vec3 armAt(const EditPlace& place) const {
    const Vec4 s = evaluate(edit_.motion().scaling, place.at.u, place.at.v);
    return turned(evaluate(edit_.motion().orientation, place.at.u, place.at.v),
                  s.head<3>().cwiseProduct(edit_.motion().point) / s[3]);
  }
  [[nodiscard]] Vec3 pointAt(const EditPlace& place) const { return evaluate(edit_.motion(), place.at.u, place.at.v).point; }
  [[nodiscard]] const Vec3& toOf(const EditPlace& place) const {
    return to_[static_cast<std::size_t>(&place - edit_.places().data())];
  }

  EditPlaces edit_;
  Vec3 axis_;
  std::vector<Vec3> to_;         ///< target of each place and copy
  double size_ = 0, reach_ = 0;  ///< largest coordinates, and distances from the trajectory, before or after
};

}  // namespace

EditResult pull(const Motion& motion, const MotionPull& options, const Progress& progress) {
  checkPull(options);
  const PullWeights weights = withLastWhole(options.weights);
  Pull edit(motion, options, progress);
  if (weights.translate > 0) edit.translate(weights.translate);
  if (weights.rotate > 0) edit.rotate(weights.rotate);
  if (weights.scale > 0) edit.scale(weights.scale, weights.rotate == 1);
  return edit.finished(weights.rotate > 0 && weights.scale == 0);
}

}  // namespace blossom::sweep
