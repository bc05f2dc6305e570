#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/dimensioned.h"

/// Units and functions of core/expression.
namespace blossom {

inline Dimensioned operator*(const Dimensioned& a, const Dimensioned& b) {
  return {a.value * b.value, a.lengths + b.lengths, a.angles + b.angles};
}
inline Dimensioned operator/(const Dimensioned& a, const Dimensioned& b) {
  return {a.value / b.value, a.lengths - b.lengths, a.angles - b.angles};
}
/// Empty when an exponent of a unit in the result would not be an integer.
std::optional<Dimensioned> power(const Dimensioned& base, double exponent);

/// Value of one unit (mm, inch, degree, radian, ..) in mm or degrees; empty when the name is no unit.
std::optional<Dimensioned> unitNamed(std::string_view);

struct ExpressionFunction {
  std::string_view name;
  std::size_t minimum, maximum;  ///< number of values
  /// Empty when the function does not accept the units of the values.
  std::optional<Dimensioned> (*call)(std::span<const Dimensioned>);
};

/// nullptr when there is no function of that name.
const ExpressionFunction* findFunction(std::string_view name);

}  // namespace blossom
