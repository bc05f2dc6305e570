#pragma once
#include <numbers>

namespace blossom {

// Radians inside, degrees for users.
inline constexpr double fullTurn = 2 * std::numbers::pi;

constexpr double toRadians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double toDegrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace blossom
