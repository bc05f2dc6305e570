#include "manipulators/marks/pull_numbers.h"

#include <algorithm>
#include <cmath>

#include "kernel/edit/motion_symmetry.h"

namespace blossom::sweep {

namespace {

constexpr int mostDecimals = 6;

/// Of a number that is told in steps of at most `step`. No "-0.000".
QString inSteps(double value, double step) {
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step))), 0, mostDecimals);
  const QString text = QString::number(value, 'f', decimals);
  return text.toDouble() == 0 ? QString::number(0.0, 'f', decimals) : text;
}

QString inRange(double value, std::pair<double, double> range) {
  constexpr double thousandth = 1.0001e-3;  // of 1, rounded: three decimals
  return inSteps(value, thousandth * (range.second - range.first));
}

}  // namespace

QString placeNumbers(const Motion& motion, const MotionPlace& at) {
  return QStringLiteral("u %1  v %2")
      .arg(inRange(insidePeriod(motion, at.u), motion.domainU()), inRange(at.v, motion.domainV()));
}

QString dragNumbers(double distance, double way, const LengthUnit& unit, double millimetresPerPixel) {
  const double step = millimetresPerPixel / unit.millimetres;
  return QStringLiteral("r %1 %2, Δ %3")
      .arg(inSteps(distance / unit.millimetres, step), QString::fromStdString(unit.name),
           inSteps(way / unit.millimetres, step));
}

}  // namespace blossom::sweep
