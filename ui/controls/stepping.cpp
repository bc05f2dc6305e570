#include "ui/controls/stepping.h"

#include <algorithm>
#include <cmath>

#include "ui/look/units.h"

namespace blossom::ui {

namespace {

/// Steps are round in the unit that is shown.
double unitOf(const ParameterSpec& spec) { return spec.kind == ParameterKind::Length ? lengthUnit().millimetres : 1; }

double plainStep(const ParameterSpec& spec, double value, Qt::KeyboardModifiers modifiers) {
  const double factor = modifiers.testFlag(Qt::ShiftModifier) ? 0.1 : modifiers.testFlag(Qt::ControlModifier) ? 10 : 1;
  if (spec.kind == ParameterKind::Count) return std::max(1.0, factor);
  if (spec.kind == ParameterKind::Angle) return factor;
  if (spec.kind == ParameterKind::Ratio) return factor * 0.01;
  const double size = std::abs(value);
  if (size == 0) return factor * (spec.kind == ParameterKind::Number ? 0.1 : 1);
  if (size >= 2 && size < 1000) return factor;
  return factor * std::pow(10, std::floor(std::log10(size)) - 1);
}

double plainMoved(const ParameterSpec& spec, double value, double steps, double step) {
  // Division by a whole number of steps per unit keeps 0.1 + 0.2 at 0.3.
  const double perUnit = 1 / step;
  const double target = value + steps * step;
  double result = step < 1 ? std::round(target * perUnit) / std::round(perUnit) : std::round(target / step) * step;
  if (!std::isfinite(result)) return value;
  if (spec.maximum) result = std::min(result, *spec.maximum);
  if (spec.minimum && result < *spec.minimum) result = *spec.minimum;
  // An open bound is approached, never reached.
  if (spec.minimum && spec.aboveMinimum && result <= *spec.minimum)
    result = *spec.minimum + std::min(step, value - *spec.minimum) / 10;
  return result;
}

}  // namespace

double stepOf(const ParameterSpec& spec, double value, Qt::KeyboardModifiers modifiers) {
  const double unit = unitOf(spec);
  return plainStep(spec, value / unit, modifiers) * unit;
}

double stepped(const ParameterSpec& spec, double value, double steps, double step) {
  const double unit = unitOf(spec);
  if (unit == 1) return plainMoved(spec, value, steps, step);
  ParameterSpec scaled = spec;
  if (scaled.minimum) *scaled.minimum /= unit;
  if (scaled.maximum) *scaled.maximum /= unit;
  double result = plainMoved(scaled, value / unit, steps, step / unit) * unit;
  // There and back a bound may be missed by a rounding.
  if (spec.maximum) result = std::min(result, *spec.maximum);
  if (spec.minimum) result = std::max(result, *spec.minimum);
  return result;
}

}  // namespace blossom::ui
