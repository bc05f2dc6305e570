#include <algorithm>
#include <array>
#include <cmath>

#include "exchange/dxf/dxf_drawing.h"

namespace blossom {
namespace {

/// Colours 10 to 249 are 24 hues in five brightnesses, each full and pale.
Color hueColor(int index) {
  static constexpr std::array<double, 5> brightness{1, 0.65, 0.5, 0.3, 0.15};
  const int hueNumber = index / 10 - 1;
  const double hue = hueNumber * 0.25;  // sixths of the circle
  const double value = brightness[static_cast<std::size_t>(index % 10 / 2)], saturation = index % 2 == 0 ? 1 : 0.5;
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6);
    return value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

Segment bulgeSegment(const Vec2& from, const Vec2& to, double bulge) {
  if (std::abs(bulge) < 1e-12) return Line2{from, to};
  const Vec2 chord = to - from;
  const Vec2 center = 0.5 * (from + to) + (1 - bulge * bulge) / (4 * bulge) * Vec2(-chord.y(), chord.x());
  const double radius = chord.norm() * (1 + bulge * bulge) / (4 * std::abs(bulge));
  return Arc2{center, radius, std::atan2(from.y() - center.y(), from.x() - center.x()), 4 * std::atan(bulge)};
}

Eigen::Matrix<double, 2, 3> dxfPlane(Vec3 n, double elevation) {
  if (!(n.norm() > 1e-9)) n = Vec3::UnitZ();
  n.normalize();
  const bool nearZ = std::abs(n.x()) < 1.0 / 64 && std::abs(n.y()) < 1.0 / 64;
  const Vec3 x = (nearZ ? Vec3::UnitY() : Vec3::UnitZ()).cross(n).normalized();
  const Vec3 y = n.cross(x);
  Eigen::Matrix<double, 2, 3> plane;
  plane << x.x(), y.x(), n.x() * elevation, x.y(), y.y(), n.y() * elevation;
  return plane;
}

std::optional<Color> dxfColor(int index) {
  static constexpr std::array<Color, 10> first{{{0, 0, 0},
                                                {1, 0, 0},
                                                {1, 1, 0},
                                                {0, 1, 0},
                                                {0, 1, 1},
                                                {0, 0, 1},
                                                {1, 0, 1},
                                                {1, 1, 1},
                                                {0.5, 0.5, 0.5},
                                                {0.75, 0.75, 0.75}}};
  if (index <= 0 || index == 7 || index > 255) return {};
  if (index < 10) return first[static_cast<std::size_t>(index)];
  if (index < 250) return hueColor(index);
  const double gray = 0.2 + 0.8 * (index - 250) / 5;
  return Color{gray, gray, gray};
}

int nearestDxfColor(const Color& color) {
  int best = 7;
  double minimum = std::pow(1 - color.red, 2) + std::pow(1 - color.green, 2) + std::pow(1 - color.blue, 2);
  for (int i = 1; i < 256; ++i) {
    const std::optional<Color> other = dxfColor(i);
    if (!other) continue;
    const double distance = std::pow(other->red - color.red, 2) + std::pow(other->green - color.green, 2) +
                            std::pow(other->blue - color.blue, 2);
    if (distance < minimum) minimum = distance, best = i;
  }
  return best;
}

}  // namespace blossom
