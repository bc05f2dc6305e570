#include "kernel/end_outline.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

constexpr int samplesInSpan = 16;

/// A closed polygon on the outline, without repeated corners.
std::vector<Vec3> cornersOfOutline(const Surface& surface, double v) {
  const auto [low, high] = surface.domainU();
  std::vector<Vec3> corners;
  const auto add = [&](const Vec3& p) {
    if (corners.empty() || p != corners.back()) corners.push_back(p);
  };
  for (std::size_t k = 0; k + 1 < surface.knotsU.size(); ++k) {
    const double from = surface.knotsU[k], to = surface.knotsU[k + 1];
    if (!(from < to) || from < low || to > high) continue;
    for (int i = 0; i < samplesInSpan; ++i) add(point(surface, from + (to - from) * i / samplesInSpan, v));
  }
  return corners;
}

double across(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Full turns of a closed polygon; nothing where a corner is so sharp that rounding may decide which way it turns.
std::optional<int> turnsOf(const std::vector<Vec2>& corners) {
  constexpr double sharp = 0.9 * std::numbers::pi;
  const std::size_t n = corners.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = corners[(i + 1) % n] - corners[i], behind = corners[(i + 2) % n] - corners[(i + 1) % n];
    const double angle = std::atan2(across(before, behind), before.dot(behind));
    if (!(std::abs(angle) < sharp)) return {};
    sum += angle;
  }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

/// Where two sides of the polygon that are no neighbours cross.
std::optional<std::size_t> crossingSide(const std::vector<Vec2>& corners, const Progress& progress) {
  const std::size_t n = corners.size();
  const auto parts = [&](std::size_t line, std::size_t side) {
    const Vec2 start = corners[line], way = corners[(line + 1) % n] - start;
    return across(way, corners[side] - start) * across(way, corners[(side + 1) % n] - start) < 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    progress.check();
    for (std::size_t k = i + 2; k < n; ++k)
      if ((k + 1) % n != i && parts(i, k) && parts(k, i)) return i;
  }
  return {};
}

}  // namespace

std::optional<Vec3> outlineCrossing(const Surface& surface, bool atEnd, const Vec3& normal, const Progress& progress) {
  const auto [first, last] = surface.domainV();
  const std::vector<Vec3> corners = cornersOfOutline(surface, atEnd ? last : first);
  if (corners.size() < 3) return {};
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vec2> flat;
  for (const Vec3& p : corners) flat.emplace_back(x.dot(p - corners[0]), y.dot(p - corners[0]));
  const std::optional<int> turns = turnsOf(flat);
  if (!turns || std::abs(*turns) == 1) return {};
  // Sides of an outline that is run through twice lie on one another: every place of it is one.
  return corners[crossingSide(flat, progress).value_or(0)];
}

}  // namespace blossom::sweep
