#include "kernel/medial/true_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "geometry/planar/planar.h"

namespace blossom::pocket {

namespace {

/// Chords of small features turn by no more than this (radians), however fine they are.
constexpr double maximumTurn = 0.3;
constexpr int deepestHalving = 24;

/// By de Casteljau's algorithm. @param row of as many poles as there are, changed
TrueCurve::Frame frameOf(std::span<Vec3> row, double t) {
  const auto degree = static_cast<int>(row.size()) - 1;
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
  for (int level = degree; level > 0; --level) {
    if (level == 2) second = degree * (degree - 1) * (row[2] - 2 * row[1] + row[0]);
    if (level == 1) first = degree * (row[1] - row[0]);
    for (int i = 0; i < level; ++i) {
      const auto k = static_cast<std::size_t>(i);
      row[k] += t * (row[k + 1] - row[k]);
    }
  }
  const double w = row[0].z();
  const Vec2 point = row[0].head<2>() / w;
  const Vec2 derivative = (first.head<2>() - first.z() * point) / w;
  return {point, derivative, (second.head<2>() - 2 * first.z() * derivative - second.z() * point) / w};
}

/// Asked some ten times for each chord of a drawing: usual degrees need no memory of their own.
TrueCurve::Frame frameOf(const BezierPiece& poles, double t) {
  constexpr std::size_t usual = 8;
  if (poles.size() > usual) {
    BezierPiece row = poles;
    return frameOf(std::span(row), t);
  }
  std::array<Vec3, usual> row;
  std::copy(poles.begin(), poles.end(), row.begin());
  return frameOf(std::span(row.data(), poles.size()), t);
}

double polygonLengthOf(const BezierPiece& piece) {
  double sum = 0;
  for (std::size_t i = 1; i < piece.size(); ++i) sum += (euclidean(piece[i]) - euclidean(piece[i - 1])).norm();
  return sum;
}

double angleOf(const Arc2& arc, double t) { return arc.start + t * arc.sweep; }

double footOnArc(const Arc2& arc, const Vec2& x, double guess) {
  const Vec2 from = x - arc.center;
  if (from.squaredNorm() == 0) return guess;
  const double wanted = std::atan2(from.y(), from.x());
  const double turns = std::round((angleOf(arc, guess) - wanted) / (2 * std::numbers::pi));
  return (wanted + turns * 2 * std::numbers::pi - arc.start) / arc.sweep;
}

/// Newton's iteration on the derivative of the squared distance. Near the centre of curvature that is flat: steps that go
/// up are shortened, and there may be many.
double footOnBezier(const TrueCurve& curve, const Vec2& x, double guess, double margin) {
  constexpr int maximumSteps = 60;
  constexpr double resolved = 1e-15, rounding = 1e-15;
  double t = guess;
  TrueCurve::Frame here = curve.at(t);
  for (int i = 0; i < maximumSteps; ++i) {
    const Vec2 offset = here.point - x;
    const double speed = here.first.squaredNorm(), slope = speed + offset.dot(here.second);
    if (!(speed > 0)) return t;
    // Beyond the centre of curvature the distance has no minimum nearby: go down its slope instead.
    const double step = offset.dot(here.first) / (slope > 1e-6 * speed ? slope : speed);
    double next = std::clamp(t - step, -margin, 1 + margin);
    TrueCurve::Frame there = curve.at(next);
    while ((there.point - x).squaredNorm() > offset.squaredNorm() * (1 + rounding) && std::abs(next - t) > resolved) {
      next = t + (next - t) / 4;
      there = curve.at(next);
    }
    if (std::abs(next - t) <= resolved) return t;
    t = next;
    here = there;
  }
  return t;
}

bool isStraight(const TrueCurve& curve, double from, double to, double chord) {
  const TrueCurve::Frame a = curve.at(from);
  const TrueCurve::Frame b = curve.at(to);
  const Vec2 along = b.point - a.point;
  const double size = along.norm();
  for (int k = 1; k < 8; ++k) {
    const Vec2 offset = curve.point(from + (to - from) * k / 8.0) - a.point;
    const double away = size > 0 ? std::abs(cross(along, offset)) / size : offset.norm();
    const double ahead = size > 0 ? offset.dot(along) / size : 0;
    if (away > chord || ahead < -chord || ahead > size + chord) return false;
  }
  if (size < 1e-3 * chord) return true;
  const Vec2 start = curve.tangent(from);
  const Vec2 end = curve.tangent(to);
  return std::atan2(std::abs(cross(start, end)), start.dot(end)) < maximumTurn;
}

void halve(const TrueCurve& curve, double from, double to, double chord, int depth, std::vector<CurveSample>& out) {
  if (depth == 0 || isStraight(curve, from, to, chord)) {
    out.push_back({to, curve.point(to)});
    return;
  }
  const double middle = (from + to) / 2;
  halve(curve, from, middle, chord, depth - 1, out);
  halve(curve, middle, to, chord, depth - 1, out);
}

}  // namespace

TrueCurve::TrueCurve(Line2 line) : value_(line), length_((line.to - line.from).norm()) {}
TrueCurve::TrueCurve(Arc2 arc) : value_(arc), length_(arc.radius * std::abs(arc.sweep)) {}
TrueCurve::TrueCurve(BezierPiece piece) : value_(std::move(piece)) {
  length_ = polygonLengthOf(std::get<BezierPiece>(value_));
}

TrueCurve::Frame TrueCurve::at(double t) const {
  if (const Line2* of = line()) return {of->from + t * (of->to - of->from), of->to - of->from, Vec2::Zero()};
  if (const Arc2* of = arc()) {
    const double angle = angleOf(*of, t);
    const Vec2 out(std::cos(angle), std::sin(angle));
    return {of->center + of->radius * out, of->radius * of->sweep * Vec2(-out.y(), out.x()),
            -of->radius * of->sweep * of->sweep * out};
  }
  return frameOf(std::get<BezierPiece>(value_), t);
}

TrueCurve::Place TrueCurve::placeAt(double t) const {
  const Frame f = at(t);
  const double speed = f.first.norm();
  if (speed > 1e-9 * length_) return {f.point, f.first / speed, cross(f.first, f.second) / (speed * speed * speed)};
  const double inside = t < 0.5 ? t + 1e-4 : t - 1e-4;
  const Vec2 limit = at(inside).first;
  return {f.point, limit.norm() > 0 ? Vec2(limit.normalized()) : Vec2(1, 0), 0};
}

double TrueCurve::foot(const Vec2& x, double guess, double margin) const {
  if (const Line2* of = line()) {
    const Vec2 along = of->to - of->from;
    return std::clamp((x - of->from).dot(along) / along.squaredNorm(), -margin, 1 + margin);
  }
  if (const Arc2* of = arc()) return std::clamp(footOnArc(*of, x, guess), -margin, 1 + margin);
  return footOnBezier(*this, x, guess, margin);
}

std::vector<TrueCurve> trueCurves(const Segment& segment) {
  std::vector<TrueCurve> curves;
  if (const auto* line = std::get_if<Line2>(&segment)) curves.emplace_back(*line);
  if (const auto* arc = std::get_if<Arc2>(&segment)) curves.emplace_back(*arc);
  if (const auto* spline = std::get_if<Spline2>(&segment))
    for (BezierPiece& piece : bezierPieces(*spline)) curves.emplace_back(std::move(piece));
  return curves;
}

std::vector<CurveSample> flattened(const TrueCurve& curve, double chord) {
  std::vector<CurveSample> out{{0, curve.point(0)}};
  if (curve.line()) {
    out.push_back({1, curve.point(1)});
  } else if (const Arc2* arc = curve.arc()) {
    const double ratio = std::clamp(chord / (2 * arc->radius), 0.0, 1.0);
    const double step = std::min(maximumTurn, 4 * std::asin(std::sqrt(ratio)));
    const int steps = std::max(1, static_cast<int>(std::min(1e7, std::ceil(std::abs(arc->sweep) / step - 1e-9))));
    for (int i = 1; i <= steps; ++i) out.push_back({double(i) / steps, curve.point(double(i) / steps)});
  } else {
    // Halves first: a closed or S-shaped piece may look straight from end to end.
    for (int i = 0; i < 4; ++i) halve(curve, i / 4.0, (i + 1) / 4.0, chord, deepestHalving, out);
  }
  return out;
}

}  // namespace blossom::pocket
