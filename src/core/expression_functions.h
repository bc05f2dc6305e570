#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace blossom {

/// A number with the powers of its units: {25.4, 1, 0} is an inch, {30, 0, 1} thirty degrees. Part of core/expression.
struct Dimensioned {
  double value = 0;
  int lengths = 0;  ///< power of mm
  int angles = 0;   ///< power of degrees

  [[nodiscard]] bool is(int lengthPower, int anglePower) const { return lengths == lengthPower && angles == anglePower; }
  [[nodiscard]] bool plain() const { return is(0, 0); }
  [[nodiscard]] bool sameUnit(const Dimensioned& other) const { return is(other.lengths, other.angles); }
  [[nodiscard]] Dimensioned with(double number) const { return {number, lengths, angles}; }
};

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
