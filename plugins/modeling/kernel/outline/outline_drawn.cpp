#include "kernel/outline/outline_drawn.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/planar/interpolate.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::modeling {
namespace {

using std::numbers::pi;

constexpr double noLength = 1e-7;     // mm: OCCT's confusion
constexpr double noCurvature = 1e-9;  // sine of the angle below which three points count as one line

Vec2 left(const Vec2& v) { return {-v.y(), v.x()}; }
double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// An angle brought into (0, 2 pi] by full turns.
double positiveTurn(double angle) {
  angle = std::fmod(angle, 2 * pi);
  return angle <= 0 ? angle + 2 * pi : angle;
}

[[noreturn]] void refuse(std::size_t k, const std::string& what, const std::string& hint) {
  throw Error(ErrorCode::InvalidInput, fmt::format("Segment {} of the outline {}.", k + 1, what), hint);
}

Segment splineThrough(const std::vector<Vec2>& points, bool periodic, const std::optional<Vec2>& direction) {
  const auto spline = interpolated(points, periodic, direction);
  if (!spline) throw Error(ErrorCode::Degenerate, "has no length", "Move its points apart.");
  return *spline;
}

/// One spline and nothing else, closed: smooth all round.
bool isRing(const DrawnOutline& outline) {
  return outline.closed && outline.segments.size() == 1 && outline.segments[0].kind == DrawnKind::Spline &&
         !outline.segments[0].through.empty();
}

Segment ring(const DrawnOutline& outline) {
  std::vector<Vec2> points{outline.start};
  const DrawnSegment& only = outline.segments[0];
  points.insert(points.end(), only.through.begin(), only.through.end());
  if ((only.to - outline.start).norm() > noLength) points.push_back(only.to);
  return splineThrough(points, true, {});
}

Segment curveOf(const DrawnSegment& segment, const Vec2& from, const std::optional<Vec2>& direction) {
  switch (segment.kind) {
    case DrawnKind::Line:
      break;
    case DrawnKind::Arc:
      if (segment.tangent) return tangentArc(from, *direction, segment.to);
      if (segment.through.size() != 1)
        throw Error(ErrorCode::Degenerate, "is an arc without a point that it passes",
                    "Give it exactly one point in between, or make it tangent to the segment before.");
      return arcThrough(from, segment.through[0], segment.to);
    case DrawnKind::Spline: {
      std::vector<Vec2> points{from};
      points.insert(points.end(), segment.through.begin(), segment.through.end());
      points.push_back(segment.to);
      return splineThrough(points, false, segment.tangent ? direction : std::nullopt);
    }
  }
  if ((segment.to - from).norm() <= noLength) throw Error(ErrorCode::Degenerate, "has no length", "Move its points apart.");
  return Line2{from, segment.to};
}

std::vector<Segment> curvesUpTo(const DrawnOutline& outline, std::size_t count) {
  std::vector<Segment> curves;
  curves.reserve(count + 1);
  Vec2 from = outline.start;
  std::optional<Vec2> direction;
  for (std::size_t k = 0; k < count; ++k) {
    const DrawnSegment& segment = outline.segments[k];
    const bool curved = segment.kind != DrawnKind::Line;
    if (curved && segment.tangent && !direction)
      refuse(k, "is to be tangent to the one before, but there is none", "Draw it through points instead.");
    try {
      curves.push_back(curveOf(segment, from, direction));
    } catch (const Error& e) {
      refuse(k, e.message(), e.hint());
    }
    from = segment.to;
    direction = endDirection(curves.back());
  }
  return curves;
}

Vec2 unit(const Vec2& v) { return v.squaredNorm() > 0 ? Vec2(v.normalized()) : Vec2(1, 0); }

Vec2 endTangent(const Spline2& spline, bool atEnd) {
  const auto pieces = bezierPieces(spline);
  return unit(atEnd ? evaluate(pieces.back(), 1).derivative : evaluate(pieces.front(), 0).derivative);
}

Vec2 arcTangent(const Arc2& arc, double angle) { return (arc.sweep > 0 ? 1 : -1) * Vec2(-std::sin(angle), std::cos(angle)); }

}  // namespace

Vec2 startDirection(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return unit(line->to - line->from);
  if (const auto* arc = std::get_if<Arc2>(&segment)) return arcTangent(*arc, arc->start);
  return endTangent(std::get<Spline2>(segment), false);
}

Vec2 endDirection(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return unit(line->to - line->from);
  if (const auto* arc = std::get_if<Arc2>(&segment)) return arcTangent(*arc, arc->start + arc->sweep);
  return endTangent(std::get<Spline2>(segment), true);
}

Segment arcThrough(const Vec2& a, const Vec2& via, const Vec2& b) {
  const Vec2 toVia = via - a, toEnd = b - a;
  if (toVia.norm() <= noLength || (via - b).norm() <= noLength)
    throw Error(ErrorCode::Degenerate, "is an arc whose points lie on each other", "Move them apart.");
  if (toEnd.norm() <= noLength) {
    const Vec2 center = (a + via) / 2;
    return Arc2{center, toVia.norm() / 2, angleOf(a - center), 2 * pi};
  }
  const double area = cross(toVia, toEnd);
  if (std::abs(area) <= noCurvature * toVia.norm() * toEnd.norm()) {
    if (toVia.dot(toEnd) > 0 && toVia.norm() < toEnd.norm()) return Line2{a, b};
    throw Error(ErrorCode::Degenerate, "is an arc through three points on one line, none of which lies between the others",
                "Move the point that it passes.");
  }
  // The circumcentre, from a.
  const Vec2 offset = left(toEnd.squaredNorm() * toVia - toVia.squaredNorm() * toEnd) / (2 * area);
  const Vec2 center = a + offset;
  const double start = angleOf(-offset), turn = positiveTurn(angleOf(b - center) - start);
  // `via` lies right of the chord on an arc that runs counter-clockwise.
  return Arc2{center, offset.norm(), start, area > 0 ? turn : turn - 2 * pi};
}

Segment tangentArc(const Vec2& a, const Vec2& direction, const Vec2& b) {
  const Vec2 chord = b - a, d = direction.normalized();
  if (chord.norm() <= noLength) throw Error(ErrorCode::Degenerate, "has no length", "Move its points apart.");
  const double side = cross(d, chord);
  if (std::abs(side) <= noCurvature * chord.norm()) {
    if (d.dot(chord) > 0) return Line2{a, b};
    throw Error(ErrorCode::Degenerate, "is a tangent arc to a point straight behind its start", "Move its end to one side.");
  }
  const double signedRadius = chord.squaredNorm() / (2 * side);
  const Vec2 center = a + signedRadius * left(d);
  const double start = angleOf(a - center), turn = positiveTurn(angleOf(b - center) - start);
  return Arc2{center, std::abs(signedRadius), start, side > 0 ? turn : turn - 2 * pi};
}

Vec2 middleOfArc(const Vec2& a, const Vec2& b, double radius, const Vec2& towards) {
  const Vec2 chord = b - a;
  const double half = chord.norm() / 2, reach = std::max(radius, half);
  const double height = reach - std::sqrt(std::max(0.0, reach * reach - half * half));
  const double side = cross(chord, towards - a) < 0 ? -1 : 1;
  return (a + b) / 2 + side * height * left(unit(chord));
}

Segment segmentOf(const DrawnOutline& outline, std::size_t k) {
  if (isRing(outline)) return ring(outline);
  return curvesUpTo(outline, k + 1).back();
}

Path toPath(const DrawnOutline& outline) {
  if (outline.segments.empty())
    throw Error(ErrorCode::InvalidInput, "The outline has no segments.", "Draw at least one line, arc or spline.");
  Path path;
  path.closed = outline.closed;
  if (isRing(outline)) {
    path.segments.push_back(ring(outline));
    return path;
  }
  path.segments = curvesUpTo(outline, outline.segments.size());
  if (!outline.closed) return path;
  const Vec2 end = outline.segments.back().to;
  if ((end - outline.start).norm() > noLength) path.segments.emplace_back(Line2{end, outline.start});
  return path;
}

bool isSound(const DrawnOutline& outline) {
  try {
    (void)toPath(outline);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace blossom::modeling
