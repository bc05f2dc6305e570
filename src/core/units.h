#pragma once
#include <string>
#include <string_view>

#include "core/dimensioned.h"

namespace blossom {

/// Literals for code and tests: `3.0_cm`, `30.0_deg`.
constexpr double operator""_mm(long double v) { return static_cast<double>(v); }
constexpr double operator""_cm(long double v) { return static_cast<double>(v * 10); }
constexpr double operator""_deg(long double v) { return static_cast<double>(v); }

constexpr double millimetresPerInch = 25.4;

/// The unit of lengths that are written without one.
struct LengthUnit {
  std::string name = "mm";
  double millimetres = 1;
  friend bool operator==(const LengthUnit&, const LengthUnit&) = default;
};

/// Length in mm from text such as "12", "3cm", "1 1/2 in", "0.5\"", "5' 6\"" or an expression "1/2 in + 3*(2 cm)" (see
/// core/expression.h). A number without a unit is in `unit`; the decimal sign is a point. Units: nm um mm cm dm m in " ft '
/// yd mil thou.
/// @param names numbers that an expression may use
/// @throws Error InvalidParameter naming the mistake and its place.
double parseLength(std::string_view text, const LengthUnit& unit = {}, const NamedNumbers& names = {});

/// "12.5 mm", "0.5 in". parseLength returns the same double for mm, and the same to thirteen digits for other units.
std::string formatLength(double millimetres, const LengthUnit& unit = {});

/// Angle in degrees from "30", "30deg", "30°", "0.5rad", "100gon", "0.25turn" or an expression "pi/4 rad". A number without
/// a unit is in degrees. @throws Error InvalidParameter.
double parseAngle(std::string_view text, const NamedNumbers& names = {});

/// Value of a plain number, a fraction "3/4" or an expression "sqrt(2)/2". @throws Error InvalidParameter.
double parseNumber(std::string_view text, const NamedNumbers& names = {});

/// The shortest text that reads back as the same double; "0.1", never "0.10000000000000001".
std::string formatNumber(double value);

/// @returns mm per unit for the name of a unit of length ("in", "mm", ..), 0 for other names.
double millimetresPer(std::string_view unit);

}  // namespace blossom
