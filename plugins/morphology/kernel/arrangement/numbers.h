#pragma once
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

/// Numbers of the exact arrangement. Coordinates are whole multiples of the grid, below 2^60; doubles with a bound of their
/// error decide nearly all signs, long integers the rest.
namespace blossom::morphology::arrangement {

__extension__ using Int128 = __int128;
/// Wide enough for the determinant of three intersections of three planes each: 1224 bits.
using Whole =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1280, 1280, boost::multiprecision::signed_magnitude,
                                                                         boost::multiprecision::unchecked, void>>;
/// Steps of the grid within which doubles find a point of the arrangement: the grid is finer than doubles of the largest
/// coordinates, and a few operations cost some bits.
inline constexpr int blur = 1 << 14;

/// Steps of the grid to which shapes are rounded as a rule. What nearly touches then touches, or is far enough apart for
/// results in doubles; only what crosses itself when it is rounded so is read as it is.
inline constexpr std::int64_t usualSteps = 1 << 13;

using Grid3 = std::array<std::int64_t, 3>;  ///< a point or a direction in units of the grid
using Normal3 = std::array<Int128, 3>;      ///< a cross product of two directions

template <class T>
int signOf(const T& value) {
  return (value > 0) - (value < 0);
}

inline Grid3 operator-(const Grid3& a, const Grid3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Grid3 operator+(const Grid3& a, const Grid3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Normal3 cross(const Grid3& a, const Grid3& b) {
  const auto part = [&](std::size_t i, std::size_t j) { return Int128(a[i]) * b[j] - Int128(a[j]) * b[i]; };
  return {part(1, 2), part(2, 0), part(0, 1)};
}
inline bool isZero(const Normal3& n) { return n[0] == 0 && n[1] == 0 && n[2] == 0; }
inline Whole dot(const Normal3& n, const Grid3& d) { return Whole(n[0]) * d[0] + Whole(n[1]) * d[1] + Whole(n[2]) * d[2]; }

/// A double and a bound of its distance from the true value. The bound of every operation is larger than needed by a few
/// units in the last place, which pays for its own rounding.
struct Bounded {
  double value = 0, error = 0;

  /// Whether the sign of the true value is known. (0 is never known to be 0, except where the error is 0.)
  [[nodiscard]] bool decided() const { return std::abs(value) > error; }
};

inline constexpr double roundOff = 3e-16;
inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const double v = a.value + b.value;
  return {v, (a.error + b.error) * (1 + roundOff) + roundOff * std::abs(v)};
}
inline Bounded operator-(const Bounded& a, const Bounded& b) { return a + Bounded{-b.value, b.error}; }
inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double v = a.value * b.value;
  return {v, (std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error) * (1 + 4 * roundOff) +
                 roundOff * std::abs(v)};
}
/// An undecided divisor makes the bound infinite.
inline Bounded operator/(const Bounded& a, const Bounded& b) {
  if (!b.decided()) return {0, HUGE_VAL};
  const double v = a.value / b.value, least = std::abs(b.value) - b.error;
  return {v, (a.error + std::abs(v) * b.error) / least * (1 + 8 * roundOff) + roundOff * std::abs(v)};
}

/// Of a whole number; exact below 2^53.
inline Bounded exactly(std::int64_t value) {
  const auto v = static_cast<double>(value);
  return {v, std::abs(v) < 0x1p53 ? 0 : roundOff * std::abs(v)};
}
inline Bounded rounded(Int128 value) {
  const auto v = static_cast<double>(value);
  return {v, roundOff * std::abs(v)};
}

using Bounded3 = std::array<Bounded, 3>;
inline Bounded3 cross(const Bounded3& a, const Bounded3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Bounded dot(const Bounded3& a, const Bounded3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Bounded3 exactly(const Grid3& p) { return {exactly(p[0]), exactly(p[1]), exactly(p[2])}; }

}  // namespace blossom::morphology::arrangement
