#include "kernel/offset/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_point.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

namespace {

double turnFrom(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

/// The arc that leaves a in direction `tangent` and ends at b.
Segment arcFrom(const Vec2& a, const Vec2& tangent, const Vec2& b) { return arcBetween(a, b, 2 * turnFrom(tangent, b - a)); }

/// One arc or line when it will do, else two arcs that meet smoothly.
std::vector<Segment> biarc(const TangentPoint& a, const TangentPoint& b) {
  const Vec2 chord = b.at - a.at;
  if (chord.squaredNorm() == 0) return {};
  const Vec2 sum = a.tangent + b.tangent;
  // |chord - d (ta + tb)|^2 = 4 d^2: the control lengths d on both sides are equal.
  const double square = 2 * (1 - a.tangent.dot(b.tangent));
  const double along = chord.dot(sum);
  const double denominator = 4 - sum.squaredNorm();
  double d = 0;
  if (denominator < 1e-12) {
    if (!(along > 0)) return {Line2{a.at, b.at}};
    d = chord.squaredNorm() / (2 * along);
  } else {
    d = (std::sqrt(along * along + denominator * chord.squaredNorm()) - along) / denominator;
  }
  if (!(d > 0) || !std::isfinite(d) || square < 0) return {Line2{a.at, b.at}};
  const Vec2 joint = (a.at + b.at + d * (a.tangent - b.tangent)) / 2;
  if ((joint - a.at).norm() < 1e-12 * chord.norm() || (joint - b.at).norm() < 1e-12 * chord.norm())
    return {Line2{a.at, b.at}};
  return {arcFrom(a.at, a.tangent, joint), reversed(arcFrom(b.at, -b.tangent, joint))};
}

bool isNear(const std::vector<Segment>& fit, const std::vector<TangentPoint>& samples, std::size_t from, std::size_t to,
            double tolerance) {
  for (const Segment& segment : fit)
    if (const auto* arc = std::get_if<Arc2>(&segment); arc && std::abs(arc->sweep) > std::numbers::pi) return false;
  for (std::size_t i = from + 1; i < to; ++i)
    if (std::none_of(fit.begin(), fit.end(), [&](const Segment& s) { return distanceTo(s, samples[i].at) <= tolerance; }))
      return false;
  return true;
}

/// Not only must the samples be near the fit, its middle must be near the samples too: it may be the complementary arc.
bool staysNear(const std::vector<Segment>& fit, const std::vector<TangentPoint>& samples, std::size_t from, std::size_t to,
               double tolerance) {
  double perimeter = 0;
  for (std::size_t i = from; i < to; ++i) perimeter += (samples[i + 1].at - samples[i].at).norm();
  double size = 0;
  for (const Segment& segment : fit) size += length(segment);
  return size <= 1.1 * perimeter + 2 * tolerance;
}

}  // namespace

Segment arcBetween(const Vec2& a, const Vec2& b, double sweep) {
  const Vec2 chord = b - a;
  // The height of the arc above its chord is chord / 2 tan(sweep / 4).
  if (std::abs(chord.norm() * std::tan(sweep / 4)) < 1e-10) return Line2{a, b};
  const double half = sweep / 2;
  const Vec2 normal(-chord.y(), chord.x());
  const Vec2 center = (a + b) / 2 + normal * (0.5 / std::tan(half));
  const Vec2 from = a - center;
  return Arc2{center, from.norm(), std::atan2(from.y(), from.x()), sweep};
}

std::vector<Segment> fittedArcs(const std::vector<TangentPoint>& samples, double tolerance) {
  std::vector<Segment> out;
  const std::size_t last = samples.empty() ? 0 : samples.size() - 1;
  const auto fit = [&](std::size_t from, std::size_t to) { return biarc(samples[from], samples[to]); };
  const auto fits = [&](const std::vector<Segment>& made, std::size_t from, std::size_t to) {
    return to == from + 1 || (isNear(made, samples, from, to, tolerance) && staysNear(made, samples, from, to, tolerance));
  };
  std::size_t step = 8;
  for (std::size_t from = 0; from < last;) {
    // As far as it goes: double the reach while it fits, then halve the rest.
    std::size_t good = from + 1;
    std::vector<Segment> best = fit(from, good);
    if (!staysNear(best, samples, from, good, 0)) best = {Line2{samples[from].at, samples[good].at}};
    for (std::size_t reach = step; reach > 0;) {
      const std::size_t to = std::min(last, good + reach);
      if (to == good) break;
      std::vector<Segment> made = fit(from, to);
      if (fits(made, from, to)) {
        good = to;
        best = std::move(made);
        if (reach >= step) {
          step *= 2;
          reach = step;
          continue;
        }
      }
      reach /= 2;
    }
    step = std::max<std::size_t>(4, (good - from) / 2);
    out.insert(out.end(), best.begin(), best.end());
    from = good;
  }
  return out;
}

}  // namespace blossom::pocket
