#include "kernel/fold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/grid/motion_point.h"

namespace blossom::sweep {

namespace {

constexpr double reversed = -0.9;  // cosine of normals

struct Tangents {
  Vec3 du, dv, normal;
};

Tangents tangentsAt(const Motion& motion, const Vec2& at) {
  const MotionPoint p = evaluate(motion, at.x(), at.y());
  return {p.du, p.dv, p.du.cross(p.dv)};
}

double cosineOf(const Vec3& a, const Vec3& b) { return a.dot(b) / (a.norm() * b.norm()); }

/// Whether a whole section is a point, through which the surface goes on as the other half of a double cone.
bool runsThroughPoint(const Motion& motion, const Vec2& at) {
  constexpr int around = 16;
  constexpr double point = 1e-6;  // of the sections beside it
  const auto [lowV, highV] = motion.domainV();
  const auto widthAt = [&motion, u = motion.domainU()](double v) {
    const Vec3 first = evaluate(motion, u.first, v).point;
    double width = 0;
    for (int k = 1; k < around; ++k)
      width = std::max(width, (evaluate(motion, u.first + (u.second - u.first) * k / around, v).point - first).norm());
    return width;
  };
  const double aside = 0.01 * (highV - lowV);
  double beside = std::numeric_limits<double>::infinity();  // at an end of the motion there are sections on one side only
  if (at.y() + aside <= highV) beside = std::min(beside, widthAt(at.y() + aside));
  if (at.y() - aside >= lowV) beside = std::min(beside, widthAt(at.y() - aside));
  return widthAt(at.y()) <= point * beside;
}

/// Whether the surface goes on along a line while the tangents across it come out the other way. At a cusp the tangent along
/// the line reverses instead, and nothing tells one that is almost sharp from a narrow edge.
bool isTurnedInsideOut(const Tangents& a, const Tangents& b, bool alongU) {
  const Vec3 &along = alongU ? a.du : a.dv, &goesOn = alongU ? b.du : b.dv;
  const Vec3 &across = alongU ? a.dv : a.du, &comesOut = alongU ? b.dv : b.du;
  return cosineOf(a.normal, b.normal) < reversed && along.dot(goesOn) > 0 && across.dot(comesOut) < 0;
}

}  // namespace

std::optional<Fold> foldBetween(const Motion& motion, Vec2 from, Vec2 to, double pinch) {
  constexpr int halvings = 24;
  constexpr double vanishing = 1e-3, opposite = -1 + 5e-7;  // of the length before; cosine
  const bool alongU = from.y() == to.y();
  const auto foldAt = [&motion](const Vec2& at, const Tangents& a, const Tangents& b) {
    return Fold{at.x(), at.y(), evaluate(motion, at.x(), at.y()).point, a.dv.dot(b.dv) < 0};
  };
  Tangents a = tangentsAt(motion, from), b = tangentsAt(motion, to);
  const double before = std::min(a.normal.norm(), b.normal.norm());
  const double tiny = pinch * std::max(a.normal.norm(), b.normal.norm());
  bool vanishes = false;
  std::optional<Fold> nearMiss;  // where the normal only almost vanishes, it turns smoothly when looked at closely enough
  for (int k = 0; k < halvings && !vanishes; ++k) {
    const Vec2 middle = (from + to) / 2;
    const Tangents m = tangentsAt(motion, middle);
    vanishes = !(m.normal.norm() > 1e-9 * before);
    if (vanishes) continue;
    if (m.normal.dot(a.normal) < 0)
      b = m, to = middle;
    else
      a = m, from = middle;
    if (std::max(a.normal.norm(), b.normal.norm()) < tiny && isTurnedInsideOut(a, b, alongU))
      nearMiss = foldAt((from + to) / 2, a, b);
  }
  vanishes = vanishes || std::max(a.normal.norm(), b.normal.norm()) < vanishing * before;
  const bool reverses = cosineOf(a.normal, b.normal) < (vanishes ? reversed : opposite);
  std::optional<Fold> fold = reverses ? foldAt((from + to) / 2, a, b) : nearMiss;
  if (!fold || runsThroughPoint(motion, {fold->u, fold->v})) return {};
  return fold;
}

bool hasNormalThere(const Motion& motion, const Vec2& at) {
  constexpr double parallel = 1e-6, vanished = 1e-3;  // sine; of the length beside
  constexpr double aside = 0.01;                      // of the domain
  const Tangents here = tangentsAt(motion, at);
  if (!(here.normal.norm() > parallel * here.du.norm() * here.dv.norm())) return false;
  const auto besideOf = [](double t, const std::pair<double, double>& domain) {
    const double step = aside * (domain.second - domain.first);
    return std::pair(std::max(t - step, domain.first), std::min(t + step, domain.second));
  };
  const auto [lowU, highU] = besideOf(at.x(), motion.domainU());
  const auto [lowV, highV] = besideOf(at.y(), motion.domainV());
  const Tangents left = tangentsAt(motion, {lowU, at.y()}), right = tangentsAt(motion, {highU, at.y()});
  const Tangents below = tangentsAt(motion, {at.x(), lowV}), above = tangentsAt(motion, {at.x(), highV});
  const bool acrossU = here.du.norm() < vanished * std::max(below.du.norm(), above.du.norm());
  const bool acrossV = here.dv.norm() < vanished * std::max(left.dv.norm(), right.dv.norm());
  return !acrossU && !acrossV && left.du.dot(right.du) > 0 && below.dv.dot(above.dv) > 0;
}

}  // namespace blossom::sweep
