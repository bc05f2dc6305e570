#pragma once
#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "core/vector.h"
#include "parameter/value.h"

namespace blossom {

/// Entries that a list of a motion file may hold.
inline constexpr std::size_t motionFileEntries = 1'000'000;

/// Largest size of a number in a motion file: 1,000 km. Products of such numbers keep a meaning, and no measure of them
/// drowns in rounding noise.
inline constexpr double motionFileNumber = 1e9;

/// A value of a motion file and the way to it, which every message names: "orientation.poles[3][2]".
/// Every member that reads a value throws Error FormatDamaged where it is of another form.
struct MotionNode {
  const Value& value;
  std::string path;

  /// @param expected what follows the path in the message: "must be a number"
  [[noreturn]] void fail(const std::string& expected) const;
  [[nodiscard]] MotionNode operator[](std::size_t index) const;
  [[nodiscard]] bool has(const char* key) const { return value.contains(key) && !value[key].is_null(); }
  [[nodiscard]] MotionNode at(const char* key) const;

  void requireObject(std::initializer_list<const char*> keys) const;
  /// @param what the entries are: "knots"
  [[nodiscard]] std::size_t arraySize(const char* what) const;
  [[nodiscard]] double number() const;
  [[nodiscard]] double numberWithin(double least, double most) const;
  [[nodiscard]] int wholeNumberWithin(int least, int most) const;
  [[nodiscard]] bool yesOrNo() const;
  template <int N>
  [[nodiscard]] Eigen::Matrix<double, N, 1> numbers(const char* what) const {
    if (!value.is_array() || value.size() != static_cast<std::size_t>(N)) fail(fmt::format("must be {}", what));
    Eigen::Matrix<double, N, 1> result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) result[static_cast<Eigen::Index>(i)] = (*this)[i].number();
    return result;
  }
  [[nodiscard]] int degree() const;
  [[nodiscard]] std::vector<double> knots() const;
};

}  // namespace blossom
