#include "kernel/offset/arc_fit.h"

#include <algorithm>
#include <cmath>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

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

Bow::Bow(const Vec2& from, const Vec2& tangent, const Vec2& to) : from_(from), to_(to), tangent_(tangent) {
  const Vec2 chord = to - from;
  const double squared = chord.squaredNorm();
  curvature_ = squared > 0 ? 2 * cross(tangent, chord) / squared : 0;
  turn_ = {tangent.dot(chord), cross(tangent, chord)};
  endTangent_ = squared > 0 ? Vec2(2 * turn_.x() / squared * chord - tangent) : tangent;
}

double Bow::sweep() const { return 2 * std::atan2(turn_.y(), turn_.x()); }

double Bow::length() const {
  const double half = std::abs(sweep()) / 2, chord = (to_ - from_).norm();
  return half > 1e-6 ? chord * half / std::sin(half) : chord;
}

bool Bow::isWithin(const Vec2& p, double distance) const {
  const Vec2 offset = p - from_;
  if (offset.dot(tangent_) < 0) return offset.squaredNorm() <= distance * distance;
  if (!isBehindEnd(p)) return (p - to_).squaredNorm() <= distance * distance;
  // | |p - c| - r | without the radius, which may be infinite.
  const Vec2 normal = toTheLeft(tangent_);
  return std::abs(curvature_ * offset.squaredNorm() - 2 * offset.dot(normal)) <=
         distance * (1 + (curvature_ * offset - normal).norm());
}

double Biarc::length() const {
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += bows[k].length();
  return sum;
}

bool Biarc::isOverHalfATurn() const {
  return std::any_of(bows.begin(), bows.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Bow& bow) { return bow.isOverHalfATurn(); });
}

bool Biarc::isWithin(const Vec2& p, double distance) const {
  if (count == 0) return false;
  const bool ofFirst = count == 1 || bows[0].isBehindEnd(p);
  if (bows[ofFirst ? 0 : 1].isWithin(p, distance)) return true;
  return count == 2 && bows[ofFirst ? 1 : 0].isWithin(p, distance);
}

Biarc biarcBetween(const TangentPoint& a, const TangentPoint& b, double within) {
  const Vec2 chord = b.at - a.at;
  if (chord.squaredNorm() == 0) return {};
  const Bow single(a.at, a.tangent, b.at);
  if (!single.isOverHalfATurn() && (single.endTangent() - b.tangent).norm() * chord.norm() <= 4 * within)
    return {{single}, 1};
  Biarc straight{{Bow::straight(a.at, b.at)}, 1};
  const Vec2 sum = a.tangent + b.tangent;
  // |chord - d (ta + tb)|^2 = 4 d^2: the control lengths d on both sides are equal.
  const double square = 2 * (1 - a.tangent.dot(b.tangent));
  const double along = chord.dot(sum);
  const double denominator = 4 - sum.squaredNorm();
  double d = 0;
  if (denominator < 1e-12) {
    if (!(along > 0)) return straight;
    d = chord.squaredNorm() / (2 * along);
  } else {
    d = (std::sqrt(along * along + denominator * chord.squaredNorm()) - along) / denominator;
  }
  if (!(d > 0) || !std::isfinite(d) || square < 0) return straight;
  const Vec2 joint = (a.at + b.at + d * (a.tangent - b.tangent)) / 2;
  if ((joint - a.at).norm() < 1e-12 * chord.norm() || (joint - b.at).norm() < 1e-12 * chord.norm()) return straight;
  const Vec2 rest = b.at - joint;
  const Vec2 tangent = 2 * b.tangent.dot(rest) / rest.squaredNorm() * rest - b.tangent;  // so that it ends along b's
  return {{Bow(a.at, a.tangent, joint), Bow(joint, tangent, b.at)}, 2};
}

namespace {

bool isNear(const Biarc& fit, const std::vector<TangentPoint>& samples, std::size_t from, std::size_t to, double tolerance) {
  if (fit.count == 0) return to == from + 1;
  if (fit.isOverHalfATurn()) return false;
  for (std::size_t i = from + 1; i < to; ++i)
    if (!fit.isWithin(samples[i].at, tolerance)) return false;
  return true;
}

/// The last sample before the joint in the middle of a fit.
std::size_t sampleBefore(const Bow& second, const std::vector<TangentPoint>& samples, std::size_t from, std::size_t to) {
  std::size_t last = from;
  while (last + 1 < to && (samples[last + 1].at - second.from()).dot(second.tangent()) <= 0) ++last;
  return last;
}

}  // namespace

std::vector<FitJoint> fittedJoints(const std::vector<TangentPoint>& samples, double tolerance) {
  if (samples.empty()) return {};
  std::vector<FitJoint> joints{{samples.front(), 0, true}};
  const std::size_t last = samples.size() - 1;
  std::vector<double> way(samples.size(), 0);  // from the first sample
  for (std::size_t i = 1; i < samples.size(); ++i) way[i] = way[i - 1] + (samples[i].at - samples[i - 1].at).norm();
  /// Not only must the samples be near the fit, its middle must be near the samples too: it may be the complementary arc.
  const auto staysNear = [&](const Biarc& made, std::size_t from, std::size_t to, double slack) {
    return made.length() <= 1.1 * (way[to] - way[from]) + 2 * slack;
  };
  const auto fits = [&](const Biarc& made, std::size_t from, std::size_t to) {
    return to == from + 1 || (isNear(made, samples, from, to, tolerance) && staysNear(made, from, to, tolerance));
  };
  std::size_t step = 8;
  for (std::size_t from = 0; from < last;) {
    // As far as it goes: double the reach while it fits, then halve the rest.
    std::size_t good = from + 1;
    Biarc best = biarcBetween(samples[from], samples[good]);
    if (best.count > 0 && !staysNear(best, from, good, 0)) best = {{Bow::straight(samples[from].at, samples[good].at)}, 1};
    for (std::size_t reach = step; reach > 0;) {
      const std::size_t to = std::min(last, good + reach);
      if (to == good) break;
      const Biarc made = biarcBetween(samples[from], samples[to]);
      if (fits(made, from, to)) {
        good = to;
        best = made;
        if (reach >= step) {
          step *= 2;
          reach = step;
          continue;
        }
      }
      reach /= 2;
    }
    step = std::max<std::size_t>(4, (good - from) / 2);
    if (best.count == 2) {
      const Bow& second = best.bows[1];
      joints.push_back({{second.from(), second.tangent()}, sampleBefore(second, samples, from, good), false});
    }
    joints.push_back({samples[good], good, true});
    from = good;
  }
  return joints;
}

}  // namespace blossom::pocket
