#include "manipulators/factors/factor_amounts.h"

#include <cmath>

namespace blossom::sweep {

double draggedFactor(const QPointF& pixels) {
  constexpr double doubling = 70, digits = 1000;
  const double factor = std::exp2(pixels.y() / doubling);
  // Small ones keep their digits, so that a drag never comes to zero.
  const double unit = std::pow(10, std::floor(std::log10(factor)));
  return std::round(factor / unit * digits) / digits * unit;
}

double draggedDegrees(const QPointF& pixels) {
  constexpr double perPixel = 0.5, mostDegrees = 360;
  return std::clamp(perPixel * std::round(pixels.x()), -mostDegrees, mostDegrees);
}

FactorChanges movedPoles(const FactorNet::Chosen& chosen, const Vec3& by) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) changes.trajectory.push_back({pole.column, false, by});
  return changes;
}

FactorChanges weightedPoles(const Motion& motion, Factor factor, const FactorNet::Chosen& chosen, double by) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) {
    if (factor == Factor::Trajectory)
      changes.weights.push_back({pole.column, by * poleValue(motion, factor, pole).weight});
    else
      changes.scaling.push_back({pole, false, Vec3::Ones(), by});
  }
  return changes;
}

FactorChanges scaledPoles(const FactorNet::Chosen& chosen, const Vec3& factors) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) changes.scaling.push_back({pole, false, factors, 1});
  return changes;
}

FactorChanges turnedPoles(const FactorNet::Chosen& chosen, const Vec3& axis, double degrees, bool absolute) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) changes.orientation.push_back({pole, absolute, axis, degrees});
  return changes;
}

FactorChanges placedPoles(const Motion& motion, Factor factor, const FactorNet::Chosen& chosen, int coordinate, double to) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) {
    Vec3 vector = poleValue(motion, factor, pole).vector;
    vector[coordinate] = to;
    if (factor == Factor::Trajectory)
      changes.trajectory.push_back({pole.column, true, vector});
    else
      changes.scaling.push_back({pole, true, vector, 1});
  }
  return changes;
}

FactorChanges weightSet(const Motion& motion, Factor factor, const FactorNet::Chosen& chosen, double to) {
  FactorChanges changes;
  for (const FactorPole& pole : chosen) {
    if (factor == Factor::Trajectory)
      changes.weights.push_back({pole.column, to});
    else
      changes.scaling.push_back({pole, false, Vec3::Ones(), to / poleValue(motion, factor, pole).weight});
  }
  return changes;
}

}  // namespace blossom::sweep
