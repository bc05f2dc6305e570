#include "kernel/outline/outline_draft.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/planar/planar.h"
#include "kernel/outline/outline_tidy.h"

namespace blossom::modeling {
namespace {}  // namespace

bool OutlineDraft::continuesSpline() const {
  return mode_ == DrawnKind::Spline && splineGoesOn_ && !outline_.segments.empty() &&
         outline_.segments.back().kind == DrawnKind::Spline;
}

void OutlineDraft::choose(DrawnKind kind) {
  if (kind == mode_ && !continuesSpline() && kind != DrawnKind::Line) tangent_ = !tangent_;
  // A spline from nothing, or after an arc through three points, is more often wanted free.
  if (kind != mode_) tangent_ = kind == DrawnKind::Arc;
  mode_ = kind;
  splineGoesOn_ = false;
  arcEnd_.reset();
}

std::optional<Vec2> OutlineDraft::from() const {
  if (!started_) return std::nullopt;
  return outline_.segments.empty() ? outline_.start : outline_.segments.back().to;
}

std::optional<Vec2> OutlineDraft::direction() const {
  if (outline_.segments.empty()) return std::nullopt;
  DrawnOutline open = outline_;
  open.closed = false;
  return endDirection(segmentOf(open, open.segments.size() - 1));
}

bool OutlineDraft::canClose() const {
  const auto& segments = outline_.segments;
  if (segments.empty() || outline_.closed) return false;
  const auto curved = [](const DrawnSegment& segment) { return segment.kind != DrawnKind::Line; };
  return segments.size() > 1 || mode_ != DrawnKind::Line || std::any_of(segments.begin(), segments.end(), curved);
}

bool OutlineDraft::closes(const Vec2& p) const { return canClose() && (p - outline_.start).norm() < 1e-9; }

SnapQuery OutlineDraft::query(const Vec2& mouse, double reach, double grid) const {
  SnapQuery query{mouse, reach, grid, from(), {}, {}};
  if (wantsMiddle()) return {mouse, reach, grid, {}, {}, {}};
  // A spline bends on, its last direction means nothing for the next point.
  if (!continuesSpline()) query.direction = direction();
  if (started_ && !outline_.segments.empty()) query.start = outline_.start;
  return query;
}

SnapScene OutlineDraft::sceneWith(SnapScene scene) const {
  if (!started_) return scene;
  if (canClose() && !wantsMiddle()) scene.points.push_back({outline_.start, SnapKind::Start});
  if (outline_.segments.empty()) return scene;
  DrawnOutline open = outline_;
  open.closed = false;
  SnapScene own;
  addToScene(own, toPath(open));
  const Vec2 last = *from();
  for (const SnapPoint& point : own.points)
    if (point.at != outline_.start && point.at != last) scene.points.push_back(point);
  scene.curves.insert(scene.curves.end(), own.curves.begin(), own.curves.end());
  return scene;
}

std::optional<Vec2> OutlineDraft::target() const {
  if (!entry_.open()) return hover_ ? std::optional(hover_->point) : std::nullopt;
  TypedEntry::Values typed;
  try {
    typed = entry_.values();
  } catch (const Error&) {
    return std::nullopt;  // entry().problem() says why
  }
  const auto begin = from();
  if (typed.place) return *typed.place + (typed.relative && begin ? *begin : Vec2(0, 0));
  if (!begin) return std::nullopt;
  const Vec2 mouse = hover_ ? hover_->point : Vec2(*begin + Vec2(1, 0));
  if (wantsMiddle()) return typed.length ? std::optional(middleOfArc(*begin, *arcEnd_, *typed.length, mouse)) : mouse;
  const Vec2 offset = mouse - *begin;
  Vec2 along = offset.norm() > 0 ? Vec2(offset.normalized()) : Vec2(1, 0);
  double length = typed.length.value_or(offset.norm());
  if (typed.angle) {
    const double angle = toRadians(*typed.angle);
    along = {std::cos(angle), std::sin(angle)};
    if (!typed.length) length = std::abs(offset.dot(along));
  }
  const Vec2 end = *begin + length * along;
  return tidied(end, std::max(sizeOf(*begin), sizeOf(end)));
}

std::optional<DrawnOutline> OutlineDraft::withSpline(DrawnOutline next, const Vec2& p, bool closing) const {
  if (!continuesSpline()) {
    next.segments.push_back({DrawnKind::Spline, p, {}, tangent()});
    return next;
  }
  // One spline alone that comes back to its start is smooth all round: its last point stays where it is.
  if (closing && next.segments.size() == 1) return next;
  DrawnSegment& spline = next.segments.back();
  spline.through.push_back(spline.to);
  spline.to = p;
  return next;
}

std::optional<DrawnOutline> OutlineDraft::withPoint(const Vec2& p, bool closing) const {
  std::optional<DrawnOutline> next = outline_;
  if (arcEnd_) {
    next->segments.push_back({DrawnKind::Arc, *arcEnd_, {p}, false});
  } else if (mode_ == DrawnKind::Spline) {
    next = withSpline(std::move(*next), p, closing);
  } else if (mode_ == DrawnKind::Arc && tangent()) {
    next->segments.push_back({DrawnKind::Arc, p, {}, true});
  } else if (!closing || mode_ == DrawnKind::Arc) {
    next->segments.push_back({DrawnKind::Line, p, {}, false});  // of a three-point arc: its chord, until the middle is known
  }
  if (next) next->closed = closing;
  if (!next || !isSound(*next)) return std::nullopt;
  return next;
}

std::optional<DrawnOutline> OutlineDraft::preview() const {
  const auto p = target();
  if (!p || !started_) return std::nullopt;
  return withPoint(*p, arcEnd_ ? arcCloses_ : closes(*p));
}

std::optional<Segment> OutlineDraft::rubber() const {
  const auto next = preview();
  if (!next) return std::nullopt;
  return toPath(*next).segments.back();
}

bool OutlineDraft::placeAt(const Vec2& p, bool closing) {
  if (!started_) {
    outline_.start = p;
    started_ = true;
    return true;
  }
  const auto next = withPoint(p, arcEnd_ ? arcCloses_ : closing);
  if (!next) return false;
  if (mode_ == DrawnKind::Arc && !tangent() && !arcEnd_) {
    arcEnd_ = p;
    arcCloses_ = closing;
    return true;
  }
  outline_ = *next;
  splineGoesOn_ = mode_ == DrawnKind::Spline;
  arcEnd_.reset();
  return true;
}

bool OutlineDraft::place() {
  if (outline_.closed) return false;
  const auto p = target();
  if (!p || !placeAt(*p, closes(*p))) return false;
  entry_.clear();
  return true;
}

bool OutlineDraft::close() {
  if (!canClose() || arcEnd_) return false;
  return placeAt(outline_.start, true);
}

bool OutlineDraft::back() {
  if (!started_) return false;
  outline_.closed = false;
  if (arcEnd_) {
    arcEnd_.reset();
    return true;
  }
  auto& segments = outline_.segments;
  if (segments.empty()) {
    started_ = false;
    return true;
  }
  if (segments.back().kind == DrawnKind::Spline && !segments.back().through.empty()) {
    segments.back().to = segments.back().through.back();
    segments.back().through.pop_back();
  } else {
    segments.pop_back();
  }
  splineGoesOn_ = mode_ == DrawnKind::Spline && !segments.empty() && segments.back().kind == DrawnKind::Spline;
  return true;
}

}  // namespace blossom::modeling
