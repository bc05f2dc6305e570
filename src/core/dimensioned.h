#pragma once
#include <functional>
#include <map>
#include <string>

namespace blossom {

/// A number with the powers of its units: {25.4, 1, 0} is an inch, {30, 0, 1} thirty degrees.
struct Dimensioned {
  double value = 0;
  int lengths = 0;  ///< power of mm
  int angles = 0;   ///< power of degrees

  [[nodiscard]] bool is(int lengthPower, int anglePower) const { return lengths == lengthPower && angles == anglePower; }
  [[nodiscard]] bool plain() const { return is(0, 0); }
  [[nodiscard]] bool sameUnit(const Dimensioned& other) const { return is(other.lengths, other.angles); }
  [[nodiscard]] Dimensioned with(double number) const { return {number, lengths, angles}; }
};

/// Numbers that expressions may use by their names.
using NamedNumbers = std::map<std::string, Dimensioned, std::less<>>;

}  // namespace blossom
