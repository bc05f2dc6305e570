#include "geometry/planar/planar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/numeric/gauss.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

Vec2 onCircle(const Arc2& arc, double angle) { return arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle)); }

Vec2 splinePoint(const Spline2& spline, double t) { return point(toCurve(spline), t).head<2>(); }

double polygonLength(const BezierPiece& piece) {
  double sum = 0;
  for (std::size_t i = 1; i < piece.size(); ++i) sum += (euclidean(piece[i]) - euclidean(piece[i - 1])).norm();
  return sum;
}

/// What rounding alone may change; no use in asking an integral for less, far from the origin.
double noise(const BezierPiece& piece) {
  double largest = 0;
  for (const Vec3& pole : piece) largest = std::max(largest, euclidean(pole).lpNorm<Eigen::Infinity>());
  return 1e-14 * largest;
}

double splineLength(const Spline2& spline) {
  double sum = 0;
  for (const BezierPiece& piece : bezierPieces(spline)) {
    const auto speed = [&](double t) { return evaluate(piece, t).derivative.norm(); };
    sum += integrate(speed, 0, 1, 1e-13 * polygonLength(piece) + noise(piece));
  }
  return sum;
}

/// Twice the area between the segment and the reference point.
double sector(const Line2& line, const Vec2& reference) { return cross(line.from - reference, line.to - reference); }

/// x - sin x, by its series where the difference would lose digits.
double lessItsSine(double x) {
  if (std::abs(x) > 1) return x - std::sin(x);
  constexpr int last = 19;  // the terms after it are below 1e-19 of the first one
  double term = x * x * x / 6, sum = term;
  for (int power = 5; power <= last; power += 2) sum += term *= -x * x / (power * (power - 1));
  return sum;
}

/// By the chord and what lies beyond it: a shallow arc has its centre far away.
double sector(const Arc2& arc, const Vec2& reference) {
  const Vec2 from = onCircle(arc, arc.start), to = onCircle(arc, arc.start + arc.sweep);
  return cross(from - reference, to - reference) + arc.radius * arc.radius * lessItsSine(arc.sweep);
}

double sector(const Spline2& spline, const Vec2& reference) {
  double sum = 0;
  for (const BezierPiece& piece : bezierPieces(spline)) {
    const auto integrand = [&](double t) {
      const auto [p, derivative] = evaluate(piece, t);
      return cross(p - reference, derivative);
    };
    const double size = polygonLength(piece);
    sum +=
        integrate(integrand, 0, 1, (1e-14 * size + noise(piece)) * ((euclidean(piece.front()) - reference).norm() + size));
  }
  return sum;
}

/// By the convex hull property: a piece whose poles are near its chord is itself near its chord.
bool isFlat(const BezierPiece& piece, double chord) {
  if (std::any_of(piece.begin(), piece.end(), [](const Vec3& pole) { return pole.z() <= 0; })) return false;
  const Vec2 from = euclidean(piece.front());
  const Vec2 along = euclidean(piece.back()) - from;
  const double squared = along.squaredNorm();
  return std::all_of(piece.begin(), piece.end(), [&](const Vec3& pole) {
    const Vec2 offset = euclidean(pole) - from;
    const double t = squared > 0 ? std::clamp(offset.dot(along) / squared, 0.0, 1.0) : 0;
    return (offset - t * along).squaredNorm() <= chord * chord;
  });
}

void flattenPiece(const BezierPiece& piece, double chord, int depth, std::vector<Vec2>& points) {
  if (depth == 0 || isFlat(piece, chord)) {
    points.push_back(euclidean(piece.back()));
    return;
  }
  const auto [left, right] = halves(piece);
  flattenPiece(left, chord, depth - 1, points);
  flattenPiece(right, chord, depth - 1, points);
}

std::vector<Vec2> flattenSegment(const Arc2& arc, double chord) {
  // The sagitta of a step a is r (1 - cos(a / 2)) = 2 r sin^2(a / 4). Never fewer than three steps a turn.
  const double ratio = std::clamp(chord / (2 * arc.radius), 0.0, 0.25);
  const double step = 4 * std::asin(std::sqrt(ratio));
  const double steps = std::ceil(std::abs(arc.sweep) / step - 1e-9);
  if (!(steps < 1e8))
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("An arc of radius {} cannot be drawn within {} mm.", arc.radius, chord), "Give a larger chord.");
  const int count = std::max(1, static_cast<int>(steps));
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) points.push_back(onCircle(arc, arc.start + arc.sweep * i / count));
  return points;
}

std::vector<Vec2> flattenSegment(const Spline2& spline, double chord) {
  constexpr int deepest = 20;
  std::vector<Vec2> points;
  for (const BezierPiece& piece : bezierPieces(spline)) {
    if (points.empty()) points.push_back(euclidean(piece.front()));
    flattenPiece(piece, chord, deepest, points);
  }
  return points;
}

std::vector<Vec2> flattenSegment(const Line2& line, double) { return {line.from, line.to}; }

}  // namespace

Vec2 startPoint(const Segment& segment) {
  return std::visit(
      Overloaded{
          [](const Line2& line) { return line.from; }, [](const Arc2& arc) { return onCircle(arc, arc.start); },
          [](const Spline2& spline) { return splinePoint(spline, spline.knots[static_cast<std::size_t>(spline.degree)]); }},
      segment);
}

Vec2 endPoint(const Segment& segment) {
  return std::visit(Overloaded{[](const Line2& line) { return line.to; },
                               [](const Arc2& arc) { return onCircle(arc, arc.start + arc.sweep); },
                               [](const Spline2& spline) { return splinePoint(spline, spline.knots[spline.poles.size()]); }},
                    segment);
}

Vec2 startPoint(const Path& path) { return startPoint(path.segments.front()); }
Vec2 endPoint(const Path& path) { return endPoint(path.segments.back()); }

Segment reversed(const Segment& segment) {
  return std::visit(Overloaded{[](const Line2& line) -> Segment {
                                 return Line2{line.to, line.from};
                               },
                               [](const Arc2& arc) -> Segment {
                                 return Arc2{arc.center, arc.radius, arc.start + arc.sweep, -arc.sweep};
                               },
                               [](const Spline2& spline) -> Segment {
                                 Spline2 back{spline.degree, {}, {spline.poles.rbegin(), spline.poles.rend()}};
                                 const double sum = spline.knots.front() + spline.knots.back();
                                 for (auto knot = spline.knots.rbegin(); knot != spline.knots.rend(); ++knot)
                                   back.knots.push_back(sum - *knot);
                                 return back;
                               }},
                    segment);
}

Path reversed(const Path& path) {
  Path back = path;
  back.segments.clear();
  for (auto segment = path.segments.rbegin(); segment != path.segments.rend(); ++segment)
    back.segments.push_back(reversed(*segment));
  return back;
}

double length(const Segment& segment) {
  return std::visit(Overloaded{[](const Line2& line) { return (line.to - line.from).norm(); },
                               [](const Arc2& arc) { return arc.radius * std::abs(arc.sweep); },
                               [](const Spline2& spline) { return splineLength(spline); }},
                    segment);
}

double length(const Path& path) {
  double sum = 0;
  for (const Segment& segment : path.segments) sum += length(segment);
  return sum;
}

std::vector<Vec2> flatten(const Segment& segment, double chord) {
  if (!(chord > 0)) throw Error(ErrorCode::InvalidParameter, fmt::format("The chord must be positive; it is {}.", chord));
  return std::visit([&](const auto& s) { return flattenSegment(s, chord); }, segment);
}

std::vector<Vec2> flatten(const Path& path, double chord) {
  std::vector<Vec2> points;
  for (const Segment& segment : path.segments) {
    const std::vector<Vec2> piece = flatten(segment, chord);
    points.insert(points.end(), piece.begin() + (points.empty() ? 0 : 1), piece.end());
  }
  if (path.closed && points.size() > 1) points.pop_back();
  return points;
}

double signedArea(const Path& path) {
  if (path.segments.empty()) return 0;
  const Vec2 reference = startPoint(path);  // near the path, so that little is lost by cancellation
  double twice = 0;
  for (const Segment& segment : path.segments)
    twice += std::visit([&](const auto& s) { return sector(s, reference); }, segment);
  return twice / 2;
}

double area(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += signedArea(loop);
  return sum;
}

Curve toCurve(const Spline2& spline) {
  Curve curve{spline.degree, spline.knots, {}};
  curve.poles.reserve(spline.poles.size());
  for (const Vec3& pole : spline.poles) curve.poles.emplace_back(pole.x(), pole.y(), 0, pole.z());
  return curve;
}

Spline2 toSpline(const Curve& curve) {
  Spline2 spline{curve.degree, curve.knots, {}};
  spline.poles.reserve(curve.poles.size());
  for (const Vec4& pole : curve.poles) spline.poles.emplace_back(pole.x(), pole.y(), pole.w());
  return spline;
}

Curves toCurves(const Region& region) {
  Curves curves;
  curves.paths = region.loops;
  return curves;
}

}  // namespace blossom
