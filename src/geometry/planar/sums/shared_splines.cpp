#include "geometry/planar/sums/shared_splines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "geometry/numeric/boxes.h"
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

/// From a parameter near it to the foot of the perpendicular, by Newton's method on the line through the tangent. Where a
/// curve bends sharply a whole step may lead away: then a part of it is made.
PlaceOnCurve footNear(const Curve& curve, const Vec2& p, double t) {
  constexpr int steps = 40, halvings = 20;
  const double from = startOf(curve), to = endOf(curve);
  PlaceOnCurve best{t, (placeAt(curve, t) - p).norm()};
  for (int k = 0; k < steps; ++k) {
    const std::vector<Vec4> d = derivatives(curve, best.t, 1);
    const Vec2 here = d[0].head<2>() / d[0].w(), along = (d[1].head<2>() - d[1].w() * here) / d[0].w();
    if (!(along.squaredNorm() > 0)) break;
    double step = (p - here).dot(along) / along.squaredNorm();
    bool isNearer = false;
    for (int half = 0; half < halvings && !isNearer; ++half, step /= 2) {
      const double next = std::clamp(best.t + step, from, to), distance = (placeAt(curve, next) - p).norm();
      if (next == best.t) break;
      isNearer = distance < best.distance;
      if (isNearer) best = {next, distance};
    }
    if (!isNearer) break;
  }
  return best;
}

constexpr int partsOfSpan(int degree) { return 4 * (degree + 1); }

/// Parameters of a span between which the curve turns little, both ends among them.
std::vector<double> samplesOf(const Curve& curve, std::size_t span) {
  const double from = curve.knots[span], to = curve.knots[span + 1];
  const int parts = partsOfSpan(curve.degree);
  std::vector<double> samples;
  for (int i = 0; i <= parts; ++i) samples.push_back(i == parts ? to : from + (to - from) * i / parts);
  return samples;
}

std::vector<double> samplesOf(const Curve& curve) {
  std::vector<double> samples;
  for (auto span = static_cast<std::size_t>(curve.degree); span < curve.poles.size(); ++span) {
    if (!(curve.knots[span + 1] > curve.knots[span])) continue;
    const std::vector<double> here = samplesOf(curve, span);
    samples.insert(samples.end(), here.begin(), here.end() - 1);
  }
  samples.push_back(endOf(curve));
  return samples;
}

/// Whether a point may lie on a span, which is in the hull of its poles.
bool mayHold(const Curve& curve, std::size_t span, const Vec2& p, double rounding) {
  Box2 box;
  for (std::size_t k = span - static_cast<std::size_t>(curve.degree); k <= span; ++k)
    box.extend(Vec2(curve.poles[k].head<2>() / curve.poles[k].w()));
  return comeNear(box, Box2(p), rounding);
}

/// The parameters, in order, at which a curve passes a point within rounding: it may do so several times.
std::vector<double> passagesOf(const Curve& curve, const Vec2& p, double rounding) {
  std::vector<double> found;
  for (auto span = static_cast<std::size_t>(curve.degree); span < curve.poles.size(); ++span) {
    if (!(curve.knots[span + 1] > curve.knots[span]) || !mayHold(curve, span, p, rounding)) continue;
    const std::vector<double> samples = samplesOf(curve, span);
    std::vector<double> distances;
    distances.reserve(samples.size());
    for (const double t : samples) distances.push_back((placeAt(curve, t) - p).norm());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const bool isLeast =
          (i == 0 || distances[i] <= distances[i - 1]) && (i + 1 == samples.size() || distances[i] <= distances[i + 1]);
      if (!isLeast) continue;
      const PlaceOnCurve foot = footNear(curve, p, samples[i]);
      if (foot.distance <= rounding) found.push_back(foot.t);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::optional<double> shareAt(const Spline2& spline, const Vec2& p, double rounding) {
  const Curve curve = toCurve(spline);
  const std::vector<double> passages = passagesOf(curve, p, rounding);
  if (passages.empty()) return std::nullopt;
  const auto distance = [&](double t) { return (placeAt(curve, t) - p).norm(); };
  const double nearest =
      *std::min_element(passages.begin(), passages.end(), [&](double s, double t) { return distance(s) < distance(t); });
  return (nearest - startOf(curve)) / (endOf(curve) - startOf(curve));
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
    const Vec2 p = placeAt(first, s);
    PlaceOnCurve foot = footNear(second, p, t);
    if (!(foot.distance <= rounding) || foot.t < t - slack) {  // it was led astray, by a bend or into another branch
      const std::vector<double> passages = passagesOf(second, p, rounding);
      const auto ahead = std::lower_bound(passages.begin(), passages.end(), t - slack);
      if (ahead == passages.end()) return false;
      foot.t = *ahead;
    }
    t = std::max(t, foot.t);
  }
  return true;
}

}  // namespace blossom::planar
