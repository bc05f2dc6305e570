#include "manipulators/marks/pull_ring.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace blossom::sweep {

namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double ringRadius = 26, letterRadius = 38, letterSize = 9, seamOfLetters = 1.3;  // pixels
constexpr double arcOfShare = 96;  // degrees; the rest of a third is a gap

using Stroke = std::vector<Vec2>;

/// Letters in a square from -1 to 1.
const std::vector<Stroke>& letter(std::size_t share) {
  static const std::array<std::vector<Stroke>, 3> all{
      {{{{-0.8, 1}, {0.8, 1}}, {{0.0, 1.0}, {0.0, -1.0}}},
       {{{-0.7, -1}, {-0.7, 1}, {0.3, 1}, {0.7, 0.75}, {0.7, 0.25}, {0.3, 0}, {-0.7, 0}}, {{0.1, 0}, {0.75, -1}}},
       {{{0.7, 0.7},
         {0.3, 1},
         {-0.3, 1},
         {-0.7, 0.7},
         {-0.7, 0.3},
         {-0.3, 0.05},
         {0.3, -0.05},
         {0.7, -0.3},
         {0.7, -0.7},
         {0.3, -1},
         {-0.3, -1},
         {-0.7, -0.7}}}}};
  return all.at(share);
}

Vec3 onScreen(const Vec3& centre, const Facing& to, const Vec2& pixels) {
  return centre + to.pixel * (pixels.x() * to.right + pixels.y() * to.up);
}

Vec2 polar(double radius, double degrees) {
  return {radius * std::cos(degrees * radian), radius * std::sin(degrees * radian)};
}

std::vector<Vec3> arcOnScreen(const Vec3& centre, const Facing& to, double radius, double from, double degrees) {
  constexpr int steps = 24;
  std::vector<Vec3> arc;
  for (int i = 0; i <= steps; ++i) arc.push_back(onScreen(centre, to, polar(radius, from + degrees * i / steps)));
  return arc;
}

}  // namespace

Facing facing(const Vec3& towards, double millimetresPerPixel) {
  const Vec3 across = towards.cross(Vec3::UnitZ());
  constexpr double fromAbove = 1e-3;
  Facing to;
  to.right = across.norm() > fromAbove ? Vec3(across.normalized()) : Vec3::UnitX();
  to.up = to.right.cross(towards).normalized();
  to.pixel = millimetresPerPixel;
  return to;
}

RingLines ringLines(const Vec3& centre, const Facing& to, const PullWeights& weights) {
  RingLines lines;
  const std::array<double, 3> shares{weights.translate, weights.rotate, weights.scale};
  const std::array<double, 3> middles{90, 330, 210};  // clockwise from the top, in the order in which they act
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double from = middles[k] - arcOfShare / 2, filled = arcOfShare * shares[k];
    // Drivers draw lines of one pixel whatever width they are asked for: three of them make an arc.
    for (const double off : {-0.7, 0.0, 0.7}) {
      const double radius = ringRadius + off;
      if (shares[k] > 0) lines.active.push_back(arcOnScreen(centre, to, radius, from, filled));
      if (shares[k] < 1) lines.idle.push_back(arcOnScreen(centre, to, radius, from + filled, arcOfShare - filled));
    }
    for (const double off : {-2.0, 2.0}) lines.border.push_back(arcOnScreen(centre, to, ringRadius + off, from, arcOfShare));
    const Vec2 middle = polar(letterRadius, middles[k]);
    for (const Stroke& stroke : letter(k)) {
      std::vector<Vec3> line;
      for (const Vec2& p : stroke) line.push_back(onScreen(centre, to, middle + letterSize / 2 * p));
      for (auto& beside : besides({line}, to, seamOfLetters)) lines.border.push_back(std::move(beside));
      (shares[k] > 0 ? lines.active : lines.idle).push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<Vec3> arcOf(const TwistArc& twist, double radius) {
  const Vec3 foot = twist.centre + twist.arm.dot(twist.axis) * twist.axis;
  Vec3 radial = twist.arm - twist.arm.dot(twist.axis) * twist.axis;
  if (!(radial.norm() > radius * 1e-3)) radial = radius * twist.axis.unitOrthogonal();
  std::vector<Vec3> arc{foot};
  constexpr double step = 3;  // degrees
  const int steps = 1 + static_cast<int>(std::abs(twist.degrees) / step);
  for (int i = 0; i <= steps; ++i)
    arc.push_back(foot + Eigen::AngleAxisd(twist.degrees * radian * i / steps, twist.axis) * radial);
  arc.push_back(foot);
  return arc;
}

std::vector<Vec3> squareOnScreen(const Vec3& centre, const Facing& to, double half) {
  std::vector<Vec3> square;
  for (const Vec2& corner : {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1)})
    square.push_back(onScreen(centre, to, half * corner));
  return square;
}

std::vector<std::vector<Vec3>> besides(const std::vector<std::vector<Vec3>>& lines, const Facing& to, double pixels) {
  std::vector<std::vector<Vec3>> all;
  for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
    for (std::vector<Vec3> line : lines) {
      for (Vec3& p : line) p = onScreen(p, to, pixels * side);
      all.push_back(std::move(line));
    }
  return all;
}

}  // namespace blossom::sweep
