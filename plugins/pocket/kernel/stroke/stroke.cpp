#include "kernel/stroke/stroke.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "geometry/planar/planar.h"

namespace blossom::pocket {

namespace {

Vec2 onCircle(const Stroke& arc, double angle) { return arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle)); }

/// Angle along an arc from its start to the direction of `d`, in the sense of the arc, 0..2 pi.
double turned(const Stroke& arc, const Vec2& d) {
  double angle = std::atan2(d.y(), d.x()) - arc.start;
  if (arc.sweep < 0) angle = -angle;
  angle = std::fmod(angle, fullTurn);
  return angle < 0 ? angle + fullTurn : angle;
}

bool spans(const Stroke& arc, const Vec2& d) { return turned(arc, d) <= std::abs(arc.sweep); }

/// Unit vectors from the centre of an arc towards and away from a point, as far as the arc spans them; its points there.
template <class Visit>
void acrossFrom(const Stroke& arc, const Vec2& p, const Visit& visit) {
  const Vec2 d = p - arc.center;
  const double norm = d.norm();
  if (norm == 0) return;
  for (const double sign : {1.0, -1.0}) {
    const Vec2 u = sign * d / norm;
    if (spans(arc, u)) visit(Vec2(arc.center + arc.radius * u));
  }
}

bool linesCross(const Stroke& a, const Stroke& b) {
  const Vec2 r = a.to - a.from, s = b.to - b.from, d = b.from - a.from;
  const double area = cross(r, s);
  if (area == 0) return false;  // parallel: an end is nearest
  const double t = cross(d, s) / area, u = cross(d, r) / area;
  return t >= 0 && t <= 1 && u >= 0 && u <= 1;
}

bool lineCrossesArc(const Stroke& line, const Stroke& arc) {
  const Vec2 along = line.to - line.from, d = line.from - arc.center;
  const double a = along.squaredNorm(), b = d.dot(along), c = d.squaredNorm() - arc.radius * arc.radius;
  const double discriminant = b * b - a * c;
  if (a == 0 || discriminant < 0) return false;
  const double root = std::sqrt(discriminant);
  for (const double sign : {-1.0, 1.0}) {
    const double t = (-b + sign * root) / a;
    if (t >= 0 && t <= 1 && spans(arc, d + t * along)) return true;
  }
  return false;
}

bool arcsCross(const Stroke& a, const Stroke& b) {
  const Vec2 d = b.center - a.center;
  const double apart = d.norm();
  if (apart == 0 || apart > a.radius + b.radius || apart < std::abs(a.radius - b.radius)) return false;
  const double along = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double height = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vec2 u = d / apart, n(-u.y(), u.x());
  for (const double sign : {-1.0, 1.0}) {
    const Vec2 p = a.center + along * u + sign * height * n;
    if (spans(a, p - a.center) && spans(b, p - b.center)) return true;
  }
  return false;
}

double lineToLine(const Stroke& a, const Stroke& b) { return linesCross(a, b) ? 0 : 1e300; }

double lineToArc(const Stroke& line, const Stroke& arc) {
  if (lineCrossesArc(line, arc)) return 0;
  const Vec2 along = line.to - line.from;
  const double squared = along.squaredNorm();
  if (squared == 0) return 1e300;
  const double t = (arc.center - line.from).dot(along) / squared;
  if (t < 0 || t > 1) return 1e300;
  const Vec2 foot = line.from + t * along;
  double best = 1e300;
  acrossFrom(arc, foot, [&](const Vec2& p) { best = std::min(best, (p - foot).norm()); });
  return best;
}

double arcToArc(const Stroke& a, const Stroke& b) {
  if (arcsCross(a, b)) return 0;
  double best = 1e300;
  acrossFrom(a, b.center,
             [&](const Vec2& p) { acrossFrom(b, a.center, [&](const Vec2& q) { best = std::min(best, (p - q).norm()); }); });
  return best;
}

}  // namespace

Stroke Stroke::line(const Vec2& from, const Vec2& to) {
  Stroke s;
  s.from = from;
  s.to = to;
  return s;
}

Stroke Stroke::arc(const Vec2& center, double radius, double start, double sweep) {
  Stroke s;
  s.round = true;
  s.center = center;
  s.radius = radius;
  s.start = start;
  s.sweep = sweep;
  s.from = onCircle(s, start);
  s.to = std::abs(sweep) >= fullTurn ? s.from : onCircle(s, start + sweep);
  return s;
}

double Stroke::length() const { return round ? radius * std::abs(sweep) : (to - from).norm(); }

Vec2 Stroke::at(double share) const {
  if (share <= 0) return from;
  if (share >= 1) return to;
  return round ? onCircle(*this, start + share * sweep) : Vec2(from + share * (to - from));
}

Vec2 Stroke::direction(double share) const {
  if (!round) {
    const double norm = (to - from).norm();
    return norm > 0 ? Vec2((to - from) / norm) : Vec2(1, 0);
  }
  const double angle = start + share * sweep;
  return (sweep < 0 ? -1 : 1) * Vec2(-std::sin(angle), std::cos(angle));
}

Stroke Stroke::part(double first, double last) const {
  Stroke s = *this;
  s.from = at(first);
  s.to = at(last);
  s.start = start + first * sweep;
  s.sweep = (last - first) * sweep;
  return s;
}

std::pair<Vec2, Vec2> Stroke::box() const {
  Vec2 low = from.cwiseMin(to), high = from.cwiseMax(to);
  if (!round) return {low, high};
  for (int k = 0; k < 4; ++k) {
    const Vec2 u = k == 0 ? Vec2(1, 0) : k == 1 ? Vec2(0, 1) : k == 2 ? Vec2(-1, 0) : Vec2(0, -1);
    if (!spans(*this, u)) continue;
    low = low.cwiseMin(center + radius * u);
    high = high.cwiseMax(center + radius * u);
  }
  return {low, high};
}

double Stroke::nearestShare(const Vec2& p) const {
  if (!round) return blossom::pocket::nearestShare(from, to, p);
  const Vec2 d = p - center;
  if (d.norm() > 0 && spans(*this, d)) return turned(*this, d) / std::abs(sweep);
  return (p - from).squaredNorm() <= (p - to).squaredNorm() ? 0 : 1;
}

double distance(const Stroke& s, const Vec2& p) {
  if (!s.round) return (s.at(s.nearestShare(p)) - p).norm();
  const Vec2 d = p - s.center;
  if (spans(s, d)) return std::abs(d.norm() - s.radius);
  return std::sqrt(std::min((p - s.from).squaredNorm(), (p - s.to).squaredNorm()));
}

double distance(const Stroke& a, const Stroke& b) {
  const double ends = std::min({distance(a, b.from), distance(a, b.to), distance(b, a.from), distance(b, a.to)});
  if (ends == 0) return 0;
  const double inner = a.round ? (b.round ? arcToArc(a, b) : lineToArc(b, a)) : b.round ? lineToArc(a, b) : lineToLine(a, b);
  return std::min(ends, inner);
}

std::vector<Stroke> strokesOf(const Path& path, double chord) {
  std::vector<Stroke> strokes;
  for (const Segment& segment : path.segments) {
    if (const auto* line = std::get_if<Line2>(&segment)) {
      strokes.push_back(Stroke::line(line->from, line->to));
    } else if (const auto* arc = std::get_if<Arc2>(&segment)) {
      strokes.push_back(Stroke::arc(arc->center, arc->radius, arc->start, arc->sweep));
    } else {
      const std::vector<Vec2> points = flatten(segment, chord);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) strokes.push_back(Stroke::line(points[i], points[i + 1]));
    }
  }
  // Rounding must leave no gap: a ray through one would not meet the outline.
  for (std::size_t i = 0; i + 1 < strokes.size(); ++i) strokes[i].to = strokes[i + 1].from;
  if (path.closed && !strokes.empty()) strokes.back().to = strokes.front().from;
  return strokes;
}

}  // namespace blossom::pocket
