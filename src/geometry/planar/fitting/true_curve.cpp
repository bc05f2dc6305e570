#include "geometry/planar/fitting/true_curve.h"

#include <algorithm>
#include <cmath>

namespace blossom::planar {
namespace {

Vec2 directionOf(const StraightCurve& line) { return (line.to - line.from).normalized(); }

Vec2 leftOf(const Vec2& v) { return {-v.y(), v.x()}; }

/// Points at a distance `aside` on either side of `foot` along a unit direction; one point when they are as good as one.
Meetings oneOrTwo(const Vec2& foot, const Vec2& along, double squaredAside, bool touches) {
  Meetings meetings;
  if (touches) {
    meetings.add(foot);
  } else if (squaredAside > 0) {
    const double aside = std::sqrt(squaredAside);
    meetings.add(foot - aside * along);
    meetings.add(foot + aside * along);
  }
  return meetings;
}

Meetings meet(const StraightCurve& a, const StraightCurve& b, double) {
  const Vec2 alongA = directionOf(a), alongB = directionOf(b);
  const double sine = cross(alongA, alongB);
  Meetings meetings;
  constexpr double parallel = 1e-12;
  if (std::abs(sine) > parallel) meetings.add(a.from + cross(Vec2(b.from - a.from), alongB) / sine * alongA);
  return meetings;
}

Meetings meet(const StraightCurve& line, const Circle& circle, double touching) {
  const Vec2 along = directionOf(line);
  const Vec2 foot = line.from + (circle.centre - line.from).dot(along) * along;
  const double height = (foot - circle.centre).norm();
  return oneOrTwo(foot, along, (circle.radius - height) * (circle.radius + height),
                  std::abs(circle.radius - height) <= touching);
}

Meetings meet(const Circle& circle, const StraightCurve& line, double touching) { return meet(line, circle, touching); }

Meetings meet(const Circle& a, const Circle& b, double touching) {
  if (a.radius < b.radius) return meet(b, a, touching);
  const Vec2 between = b.centre - a.centre;
  const double distance = between.norm();
  if (!(distance > 0)) return {};
  const Vec2 along = between / distance;
  const bool outside = std::abs(distance - (a.radius + b.radius)) <= touching;
  const bool inside = std::abs(distance - (a.radius - b.radius)) <= touching && distance > touching;
  if (outside || inside) return oneOrTwo(b.centre + (inside ? 1 : -1) * b.radius * along, leftOf(along), 0, true);
  // From the centre of the smaller one, which is told better, to the common chord, whose half is the height of a triangle
  // with sides a, b and the distance (Heron).
  const double reach = ((distance - a.radius) * (distance + a.radius) + b.radius * b.radius) / (2 * distance);
  return oneOrTwo(b.centre - reach * along, leftOf(along), (b.radius - reach) * (b.radius + reach), false);
}

bool same(const StraightCurve& a, const StraightCurve& b, double within) {
  if ((a.to - a.from).squaredNorm() < (b.to - b.from).squaredNorm()) return same(b, a, within);  // the longer one tells
  const Vec2 along = directionOf(a);
  const auto aside = [&](const Vec2& p) { return std::abs(cross(along, Vec2(p - a.from))); };
  return aside(b.from) <= within && aside(b.to) <= within;
}

bool same(const Circle& a, const Circle& b, double within) {
  return (a.centre - b.centre).norm() <= within && std::abs(a.radius - b.radius) <= within;
}

template <class A, class B>
bool same(const A&, const B&, double) {
  return false;
}

template <class Other>
Meetings meet(const FreeSide&, const Other&, double) {
  return {};
}
template <class Other>
Meetings meet(const Other&, const FreeSide&, double) {
  return {};
}
Meetings meet(const FreeSide&, const FreeSide&, double) { return {}; }

}  // namespace

TrueCurve trueCurveOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return StraightCurve{line->from, line->to};
  const auto& arc = std::get<Arc2>(segment);
  return Circle{arc.center, arc.radius};
}

bool isFree(const TrueCurve& curve) { return std::holds_alternative<FreeSide>(curve); }

Vec2 nearestOn(const TrueCurve& curve, const Vec2& p) {
  if (const auto* line = std::get_if<StraightCurve>(&curve)) {
    const Vec2 along = directionOf(*line);
    return line->from + (p - line->from).dot(along) * along;
  }
  if (isFree(curve)) return p;
  const auto& circle = std::get<Circle>(curve);
  const Vec2 out = p - circle.centre;
  const double distance = out.norm();
  return circle.centre + circle.radius * (distance > 0 ? Vec2(out / distance) : Vec2::UnitX());
}

bool sameCurve(const TrueCurve& a, const TrueCurve& b, double within) {
  return std::visit([&](const auto& first, const auto& second) { return same(first, second, within); }, a, b);
}

Meetings meetingsOf(const TrueCurve& a, const TrueCurve& b, double touching) {
  return std::visit([&](const auto& first, const auto& second) { return meet(first, second, touching); }, a, b);
}

}  // namespace blossom::planar
