#include "core/units.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/expression.h"

namespace blossom {
namespace {

using UnitTable = std::array<std::pair<std::string_view, double>, 17>;

constexpr UnitTable lengthUnits{{{"mm", 1},
                                 {"nm", 1e-6},
                                 {"um", 1e-3},
                                 {"µm", 1e-3},
                                 {"μm", 1e-3},
                                 {"cm", 10},
                                 {"dm", 100},
                                 {"m", 1000},
                                 {"in", millimetresPerInch},
                                 {"inch", millimetresPerInch},
                                 {"\"", millimetresPerInch},
                                 {"''", millimetresPerInch},
                                 {"ft", 12 * millimetresPerInch},
                                 {"'", 12 * millimetresPerInch},
                                 {"yd", 36 * millimetresPerInch},
                                 {"mil", millimetresPerInch / 1000},
                                 {"thou", millimetresPerInch / 1000}}};

}  // namespace

double millimetresPer(std::string_view unit) {
  for (const auto& [name, factor] : lengthUnits)
    if (name == unit) return factor;
  return 0;
}

double parseLength(std::string_view text, const LengthUnit& unit, const NamedNumbers& known) {
  return evaluateExpression(text, Quantity::Length, unit, known);
}
double parseAngle(std::string_view text, const NamedNumbers& known) {
  return evaluateExpression(text, Quantity::Angle, {}, known);
}
double parseNumber(std::string_view text, const NamedNumbers& known) {
  return evaluateExpression(text, Quantity::Number, {}, known);
}

std::string formatNumber(double value) { return fmt::format("{}", value); }

std::string formatLength(double millimetres, const LengthUnit& unit) {
  const double value = millimetres / unit.millimetres;
  return fmt::format("{} {}", unit.millimetres == 1 ? formatNumber(value) : fmt::format("{:.13g}", value), unit.name);
}

}  // namespace blossom
