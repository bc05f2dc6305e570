#include "geometry/planar/sums/shared_splines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

struct PlaceOnCurve {
  double t = 0;
  double distance = 0;
};

double startOf(const Curve& curve) { return curve.knots[static_cast<std::size_t>(curve.degree)]; }
double endOf(const Curve& curve) { return curve.knots[curve.poles.size()]; }

Vec2 placeAt(const Curve& curve, double t) { return point(curve, t).head<2>(); }

/// From a parameter near it to the foot of the perpendicular, by Newton's method on the line through the tangent.
PlaceOnCurve footNear(const Curve& curve, const Vec2& p, double t) {
  constexpr int steps = 12;
  const double from = startOf(curve), to = endOf(curve);
  for (int k = 0; k < steps; ++k) {
    const std::vector<Vec4> d = derivatives(curve, t, 1);
    const Vec2 here = d[0].head<2>() / d[0].w(), along = (d[1].head<2>() - d[1].w() * here) / d[0].w();
    if (!(along.squaredNorm() > 0)) break;
    const double next = std::clamp(t + (p - here).dot(along) / along.squaredNorm(), from, to);
    if (next == t) break;
    t = next;
  }
  return {t, (placeAt(curve, t) - p).norm()};
}

/// Parameters between which a curve turns little: some in each span.
std::vector<double> samplesOf(const Curve& curve) {
  const int parts = 4 * (curve.degree + 1);
  std::vector<double> samples;
  for (auto k = static_cast<std::size_t>(curve.degree); k < curve.poles.size(); ++k) {
    const double from = curve.knots[k], to = curve.knots[k + 1];
    if (!(to > from)) continue;
    for (int i = 0; i < parts; ++i) samples.push_back(from + (to - from) * i / parts);
  }
  samples.push_back(endOf(curve));
  return samples;
}

}  // namespace

std::optional<double> shareAt(const Spline2& spline, const Vec2& p, double rounding) {
  const Curve curve = toCurve(spline);
  PlaceOnCurve nearest{0, HUGE_VAL};
  for (const double t : samplesOf(curve)) {
    const double distance = (placeAt(curve, t) - p).norm();
    if (distance < nearest.distance) nearest = {t, distance};
  }
  nearest = footNear(curve, p, nearest.t);
  if (!(nearest.distance <= rounding)) return std::nullopt;
  return (nearest.t - startOf(curve)) / (endOf(curve) - startOf(curve));
}

Spline2 splinePart(const Spline2& spline, double from, double to) {
  Curve curve = clamped(toCurve(spline));
  const double start = startOf(curve), length = endOf(curve) - start;
  const std::array<double, 2> ends{from > 0 ? start + from * length : start, to < 1 ? start + to * length : endOf(curve)};
  std::vector<double> more;
  for (const double t : ends) {
    const auto known = std::count(curve.knots.begin(), curve.knots.end(), t);
    more.insert(more.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(curve.degree + 1 - known, 0)), t);
  }
  curve = insertKnots(curve, more);
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), ends[0]);
  const auto last = std::upper_bound(curve.knots.begin(), curve.knots.end(), ends[1]);
  const auto begin = first - curve.knots.begin(), knots = last - first;
  Curve part;
  part.degree = curve.degree;
  part.knots.assign(first, last);
  part.poles.assign(curve.poles.begin() + begin, curve.poles.begin() + begin + knots - curve.degree - 1);
  return toSpline(part);
}

bool runTogether(const Spline2& a, const Spline2& b, double rounding) {
  const Curve first = toCurve(a), second = toCurve(b);
  const double slack = 1e-9 * (endOf(second) - startOf(second));
  double t = startOf(second);
  for (const double s : samplesOf(first)) {
    const PlaceOnCurve foot = footNear(second, placeAt(first, s), t);
    if (!(foot.distance <= rounding) || foot.t < t - slack) return false;
    t = std::max(t, foot.t);
  }
  return true;
}

}  // namespace blossom::planar
