#include "kernel/edit/factor_changes.h"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "kernel/quaternion.h"
#include "kernel/vanishing.h"

namespace blossom::sweep {

namespace {

constexpr double mostDegrees = 360;
constexpr double mostNumber = 1e9;  // of a motion file, to which what is edited can be written

[[noreturn]] void refuseChange(const std::string& place, const std::string& problem, const std::string& remedy) {
  throw Error(ErrorCode::InvalidParameter, place + ": " + problem, remedy);
}

std::string factorPlace(const char* list, std::size_t index, std::size_t pole) {
  return fmt::format("{}[{}], pole {}", list, index, pole);
}

std::string factorPlace(const char* list, std::size_t index, const FactorPole& pole) {
  return fmt::format("{}[{}], pole ({}, {})", list, index, pole.row, pole.column);
}

void requireNumbers(const Vec3& numbers, const std::string& place) {
  if (!numbers.allFinite()) refuseChange(place, "a number is not finite.", "Give finite numbers.");
  if (numbers.cwiseAbs().maxCoeff() > mostNumber)
    refuseChange(place, "a number is beyond 1e9, the largest of a motion.", "Give numbers between -1e9 and 1e9.");
}

void requireNumber(double number, const std::string& place) { requireNumbers(Vec3::Constant(number), place); }

void requireFactorIndex(std::size_t index, std::size_t count, const char* what, const std::string& place) {
  if (index >= count)
    refuseChange(place, fmt::format("there is no such pole, for the {}s are counted from 0 to {}.", what, count - 1),
                 fmt::format("Choose a {} up to {}.", what, count - 1));
}

void requireFactorPole(const FactorPole& pole, std::size_t rows, std::size_t columns, const std::string& place) {
  requireFactorIndex(pole.row, rows, "row", place);
  requireFactorIndex(pole.column, columns, "column", place);
}

void requireFactorWeight(double weight, const std::string& place) {
  requireNumber(weight, place);
  if (!(weight > 0)) refuseChange(place, fmt::format("its weight would be {}.", weight), "Weights must be above 0.");
}

void moveTrajectory(Curve& trajectory, const FactorChanges& changes) {
  const auto take = [&](const char* list, std::size_t k, std::size_t pole) -> Vec4& {
    requireFactorIndex(pole, trajectory.poles.size(), "pole", factorPlace(list, k, pole));
    return trajectory.poles[pole];
  };
  for (std::size_t k = 0; k < changes.trajectory.size(); ++k) {
    const TrajectoryMove& change = changes.trajectory[k];
    Vec4& pole = take("trajectory", k, change.pole);
    requireNumbers(change.vector, factorPlace("trajectory", k, change.pole));
    const Vec3 from = change.absolute ? Vec3::Zero() : Vec3(pole.head<3>());
    pole.head<3>() = from + pole[3] * change.vector;
  }
  for (std::size_t k = 0; k < changes.weights.size(); ++k) {
    const TrajectoryWeight& change = changes.weights[k];
    Vec4& pole = take("weights", k, change.pole);
    requireFactorWeight(change.weight, factorPlace("weights", k, change.pole));
    pole.head<3>() *= change.weight / pole[3];
    pole[3] = change.weight;
  }
}

Vec4 turnOf(const OrientationTurn& change, const std::string& place) {
  requireNumbers(change.axis, place);
  requireNumber(change.angle, place);
  if (!(std::abs(change.angle) <= mostDegrees))
    refuseChange(place, "it would turn by more than 360 degrees, which is no other orientation.",
                 "Give an angle between -360 and 360 degrees.");
  if (change.angle == 0) return {1, 0, 0, 0};
  const double length = change.axis.norm();
  if (!(length > 0)) refuseChange(place, "its axis has no length.", "Give a direction, such as 0,0,1.");
  return rotationAbout(change.axis / length, toRadians(change.angle));
}

Vec4 turnedPole(const Vec4& pole, const OrientationTurn& change, const std::string& place) {
  const Vec4 dq = turnOf(change, place);
  if (!change.absolute) return times(dq, pole);
  // A pole of length 0 has no direction to keep the sign of.
  const double length = pole.norm() > 0 ? pole.norm() : 1;
  return (dq.dot(pole) < 0 ? -length : length) * dq;
}

void turnOrientation(Surface& orientation, std::size_t rows, const std::vector<OrientationTurn>& changes) {
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::string place = factorPlace("orientation", k, changes[k].pole);
    requireFactorPole(changes[k].pole, rows, orientation.countV(), place);
    Vec4& pole = orientation.pole(changes[k].pole.row, changes[k].pole.column);
    pole = turnedPole(pole, changes[k], place);
  }
}

void changeScaling(Surface& scaling, std::size_t rows, const std::vector<ScalingChange>& changes) {
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const ScalingChange& change = changes[k];
    const std::string place = factorPlace("scaling", k, change.pole);
    requireFactorPole(change.pole, rows, scaling.countV(), place);
    requireNumbers(change.factors, place);
    requireFactorWeight(change.weight, place);
    Vec4& pole = scaling.pole(change.pole.row, change.pole.column);
    const Vec3 factors =
        change.absolute ? Vec3(pole[3] * change.factors) : Vec3(pole.head<3>().cwiseProduct(change.factors));
    pole.head<3>() = change.weight * factors;
    pole[3] *= change.weight;
    requireFactorWeight(pole[3], place);
  }
}

void repeatRows(Surface& factor, std::size_t rows, double sign) {
  for (std::size_t i = rows; i < factor.countU(); ++i)
    for (std::size_t j = 0; j < factor.countV(); ++j) factor.pole(i, j) = sign * factor.pole(i - rows, j);
}

std::size_t countChanged(const std::vector<Vec4>& a, const std::vector<Vec4>& b, std::size_t count) {
  std::size_t different = 0;
  for (std::size_t k = 0; k < count; ++k) different += a[k] != b[k] ? 1 : 0;
  return different;
}

/// The last change of a pole in a list, when it can be changed further; nullptr: there is none.
template <class Change>
Change* lastChange(std::vector<Change>& list, const Change& like) {
  for (std::size_t k = list.size(); k-- > 0;)
    if (list[k].pole == like.pole) return &list[k];
  return nullptr;
}

template <class Change, class Join>
void joinChanges(std::vector<Change>& first, const std::vector<Change>& second, const Join& joined) {
  for (const Change& change : second) {
    Change* const last = lastChange(first, change);
    if (!last || !joined(*last, change)) first.push_back(change);
  }
}

bool joinedMove(TrajectoryMove& last, const TrajectoryMove& next) {
  if (next.absolute)
    last = next;
  else
    last.vector += next.vector;
  return true;
}

bool joinedWeight(TrajectoryWeight& last, const TrajectoryWeight& next) {
  last = next;
  return true;
}

/// Of an absolute turn only the rotation is known, not the sign it takes: a further turn stands by itself.
bool joinedTurn(OrientationTurn& last, const OrientationTurn& next) {
  // What is wrong is told where it is applied.
  const auto sound = [](const OrientationTurn& turn) {
    return std::abs(turn.angle) <= mostDegrees && turn.axis.allFinite() && turn.axis.norm() > 0;
  };
  if (next.absolute || last.absolute || !sound(last) || !sound(next)) return false;
  const std::string nowhere;
  const Vec4 dq = times(turnOf(next, nowhere), turnOf(last, nowhere));
  const double sine = dq.tail<3>().norm();
  last.angle = 2 * toDegrees(std::atan2(sine, dq[0]));
  // Of a full turn, or none, any axis will do.
  if (sine > 0) last.axis = dq.tail<3>() / sine;
  return true;
}

bool joinedScaling(ScalingChange& last, const ScalingChange& next) {
  last.factors = next.absolute ? next.factors : Vec3(last.factors.cwiseProduct(next.factors));
  last.absolute = last.absolute || next.absolute;
  last.weight *= next.weight;
  return true;
}

}  // namespace

bool FactorChanges::empty() const { return trajectory.empty() && weights.empty() && orientation.empty() && scaling.empty(); }

std::size_t freeRows(const Motion& motion, const Surface& factor) {
  return factor.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(factor.degreeU));
}

FactorChangeResult withChangedFactors(const Motion& given, const FactorChanges& changes, const Progress& progress) {
  FactorChangeResult result{given};
  Motion& motion = result.motion;
  progress.check();
  moveTrajectory(motion.trajectory, changes);
  const std::size_t turning = freeRows(motion, motion.orientation), scaling = freeRows(motion, motion.scaling);
  turnOrientation(motion.orientation, turning, changes.orientation);
  changeScaling(motion.scaling, scaling, changes.scaling);
  repeatRows(motion.orientation, turning, motion.closedU == ClosedU::AntiPeriodic ? -1 : 1);
  repeatRows(motion.scaling, scaling, 1);
  if (!changes.orientation.empty()) requireNonVanishing(motion.orientation, progress);
  result.changedPoles =
      countChanged(given.trajectory.poles, motion.trajectory.poles, given.trajectory.poles.size()) +
      countChanged(given.orientation.poles, motion.orientation.poles, turning * motion.orientation.countV()) +
      countChanged(given.scaling.poles, motion.scaling.poles, scaling * motion.scaling.countV());
  return result;
}

FactorChanges followedBy(FactorChanges first, const FactorChanges& second) {
  joinChanges(first.trajectory, second.trajectory, joinedMove);
  joinChanges(first.weights, second.weights, joinedWeight);
  joinChanges(first.orientation, second.orientation, joinedTurn);
  joinChanges(first.scaling, second.scaling, joinedScaling);
  return first;
}

}  // namespace blossom::sweep
