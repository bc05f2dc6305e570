#include "kernel/outline/outline_edit.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::modeling {
namespace {

constexpr double samePlace = 1e-9;

bool comesBack(const DrawnOutline& outline) {
  return outline.closed && outline.segments.size() > 1 && (outline.segments.back().to - outline.start).norm() < samePlace;
}

Vec2 beginOf(const DrawnOutline& outline, std::size_t k) { return k == 0 ? outline.start : outline.segments[k - 1].to; }

/// The similarity that maps one chord to another, applied to p.
Vec2 carried(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& newA, const Vec2& newB) {
  const Vec2 before = b - a, after = newB - newA, offset = p - a;
  if (before.squaredNorm() == 0) return p + (newA - a);
  const double c = before.dot(after) / before.squaredNorm();
  const double s = (before.x() * after.y() - before.y() * after.x()) / before.squaredNorm();
  return newA + Vec2(c * offset.x() - s * offset.y(), s * offset.x() + c * offset.y());
}

void makeLine(DrawnSegment& segment) { segment = {DrawnKind::Line, segment.to, {}, false}; }

/// What cannot be drawn as it was any more is drawn straight.
std::optional<DrawnOutline> mended(DrawnOutline outline) {
  if (outline.segments.empty()) return std::nullopt;
  if (DrawnSegment& first = outline.segments.front(); first.tangent) {
    if (first.kind == DrawnKind::Arc) makeLine(first);
    first.tangent = false;
  }
  if (isSound(outline)) return outline;
  for (DrawnSegment& segment : outline.segments)
    if (segment.kind == DrawnKind::Arc) makeLine(segment);
  if (isSound(outline)) return outline;
  return std::nullopt;
}

std::optional<DrawnOutline> withoutStart(DrawnOutline outline) {
  const bool back = comesBack(outline);
  outline.start = outline.segments.front().to;
  outline.segments.erase(outline.segments.begin());
  if (outline.segments.empty()) return std::nullopt;
  if (back) outline.segments.back().to = outline.start;
  return mended(std::move(outline));
}

/// Nearest point of a Bézier piece: samples, then the best neighbourhood ever finer.
std::pair<double, Vec2> nearestOn(const BezierPiece& piece, const Vec2& p) {
  double from = 0, to = 1, best = 0;
  Vec2 place = evaluate(piece, 0).point;
  for (int round = 0; round < 12; ++round) {
    const double step = (to - from) / 16;
    for (int k = 0; k <= 16; ++k) {
      const Vec2 here = evaluate(piece, from + k * step).point;
      if ((here - p).norm() < (place - p).norm()) place = here, best = from + k * step;
    }
    from = std::max(0.0, best - step);
    to = std::min(1.0, best + step);
  }
  return {(place - p).norm(), place};
}

OutlinePlace nearestOn(const Segment& segment, const Vec2& p) {
  if (const auto* spline = std::get_if<Spline2>(&segment)) {
    OutlinePlace best{0, p, 1e300, 0};
    int piece = 0;
    for (const BezierPiece& curve : bezierPieces(*spline)) {
      const auto [distance, place] = nearestOn(curve, p);
      if (distance < best.distance) best = {0, place, distance, piece};
      ++piece;
    }
    return best;
  }
  Vec2 place;
  if (const auto* line = std::get_if<Line2>(&segment)) {
    const Vec2 along = line->to - line->from;
    place = line->from + std::clamp((p - line->from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
  } else {
    const auto& arc = std::get<Arc2>(segment);
    const Vec2 offset = p - arc.center;
    double turn = std::fmod((std::atan2(offset.y(), offset.x()) - arc.start) * (arc.sweep > 0 ? 1 : -1), fullTurn);
    if (turn < 0) turn += fullTurn;
    place = arc.center + arc.radius * offset.normalized();
    const Vec2 a = startPoint(segment), b = endPoint(segment);
    if (turn > std::abs(arc.sweep)) place = (a - p).norm() < (b - p).norm() ? a : b;
  }
  return {0, place, (place - p).norm(), 0};
}

Vec2 middle(const Segment& segment) {
  const auto* arc = std::get_if<Arc2>(&segment);
  if (!arc) return (startPoint(segment) + endPoint(segment)) / 2;
  const double angle = arc->start + arc->sweep / 2;
  return arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle));
}

/// The parts of an arc before and after a point of it.
std::pair<Segment, Segment> splitArc(const Arc2& arc, const Vec2& at) {
  const Vec2 offset = at - arc.center;
  double turn = std::fmod((std::atan2(offset.y(), offset.x()) - arc.start) * (arc.sweep > 0 ? 1 : -1), fullTurn);
  if (turn < 0) turn += fullTurn;
  const double first = std::copysign(std::min(turn, std::abs(arc.sweep)), arc.sweep);
  return {Arc2{arc.center, arc.radius, arc.start, first},
          Arc2{arc.center, arc.radius, arc.start + first, arc.sweep - first}};
}

}  // namespace

std::vector<OutlineHandle> handlesOf(const DrawnOutline& outline) {
  std::vector<OutlineHandle> handles{{-1, -1, outline.start}};
  const bool back = comesBack(outline);
  for (std::size_t k = 0; k < outline.segments.size(); ++k) {
    const DrawnSegment& segment = outline.segments[k];
    for (std::size_t i = 0; i < segment.through.size(); ++i)
      handles.push_back({static_cast<int>(k), static_cast<int>(i), segment.through[i]});
    if (!back || k + 1 < outline.segments.size()) handles.push_back({static_cast<int>(k), -1, segment.to});
  }
  return handles;
}

DrawnOutline moved(const DrawnOutline& outline, const OutlineHandle& handle, const Vec2& to) {
  DrawnOutline next = outline;
  if (handle.through >= 0) {
    next.segments.at(static_cast<std::size_t>(handle.segment)).through.at(static_cast<std::size_t>(handle.through)) = to;
    return next;
  }
  if (handle.segment < 0) {
    next.start = to;
    if (comesBack(outline)) next.segments.back().to = to;
  } else {
    next.segments.at(static_cast<std::size_t>(handle.segment)).to = to;
  }
  for (std::size_t k = 0; k < next.segments.size(); ++k) {
    DrawnSegment& segment = next.segments[k];
    if (segment.kind != DrawnKind::Arc || segment.through.size() != 1) continue;
    segment.through[0] =
        carried(segment.through[0], beginOf(outline, k), outline.segments[k].to, beginOf(next, k), segment.to);
  }
  return next;
}

std::optional<DrawnOutline> without(const DrawnOutline& outline, const OutlineHandle& handle) {
  if (outline.segments.empty()) return std::nullopt;
  if (handle.segment < 0) return withoutStart(outline);
  DrawnOutline next = outline;
  const auto k = static_cast<std::size_t>(handle.segment);
  DrawnSegment& segment = next.segments.at(k);
  if (handle.through >= 0) {
    segment.through.erase(segment.through.begin() + handle.through);
    if (segment.kind == DrawnKind::Arc) makeLine(segment);
    return mended(std::move(next));
  }
  if (segment.kind == DrawnKind::Spline && !segment.through.empty() && k + 1 == next.segments.size()) {
    segment.to = segment.through.back();
    segment.through.pop_back();
    return mended(std::move(next));
  }
  next.segments.erase(next.segments.begin() + handle.segment);
  return mended(std::move(next));
}

std::optional<OutlinePlace> nearestPlace(const DrawnOutline& outline, const Vec2& p) {
  if (!isSound(outline)) return std::nullopt;
  const Path path = toPath(outline);
  std::optional<OutlinePlace> best;
  for (std::size_t k = 0; k < path.segments.size(); ++k) {
    OutlinePlace place = nearestOn(path.segments[k], p);
    place.segment = static_cast<int>(k);
    if (!best || place.distance < best->distance) best = place;
  }
  return best;
}

DrawnOutline withPointAt(const DrawnOutline& outline, const OutlinePlace& place) {
  DrawnOutline next = outline;
  const auto k = static_cast<std::size_t>(place.segment);
  if (k >= outline.segments.size()) {
    next.segments.push_back({DrawnKind::Line, place.at, {}, false});
    return next;
  }
  DrawnSegment& segment = next.segments[k];
  if (segment.kind == DrawnKind::Spline) {
    // The last piece of a ring runs from its last point back to the start.
    auto& through = segment.through;
    const auto piece = static_cast<std::size_t>(place.piece);
    if (piece <= through.size()) {
      through.insert(through.begin() + place.piece, place.at);
    } else {
      through.push_back(segment.to);
      segment.to = place.at;
    }
    return next;
  }
  DrawnSegment first{segment.kind, place.at, {}, segment.tangent};
  const Segment curve = segmentOf(outline, k);
  if (const auto* arc = std::get_if<Arc2>(&curve); arc && !segment.tangent) {
    const auto [before, after] = splitArc(*arc, place.at);
    first.through = {middle(before)};
    segment.through = {middle(after)};
  }
  next.segments.insert(next.segments.begin() + place.segment, std::move(first));
  return next;
}

std::optional<Vec2> pointBefore(const DrawnOutline& outline, const OutlineHandle& handle) {
  if (handle.through >= 0) return std::nullopt;
  if (handle.segment >= 0) return beginOf(outline, static_cast<std::size_t>(handle.segment));
  if (!outline.closed || outline.segments.empty()) return std::nullopt;
  return comesBack(outline) ? beginOf(outline, outline.segments.size() - 1) : outline.segments.back().to;
}

}  // namespace blossom::modeling
