#include "kernel/outline/outline_sides.h"

#include <cmath>

#include "kernel/outline/outline_tidy.h"

namespace blossom::modeling {

namespace {

/// Corners of an outline and what joins them: corner k is the start of segment k. A closed outline that does not return to
/// its start has a last segment of its own, the line that closes it.
class Ring {
 public:
  explicit Ring(const DrawnOutline& outline) : outline_(outline) {
    corners_.push_back(outline.start);
    for (const DrawnSegment& segment : outline.segments) corners_.push_back(segment.to);
    returns_ = outline.closed && corners_.size() > 1 && corners_.back() == corners_.front();
    if (returns_) corners_.pop_back();
  }
  [[nodiscard]] int segments() const {
    const int drawn = static_cast<int>(outline_.segments.size());
    return drawn + (outline_.closed && !returns_ && drawn > 1 ? 1 : 0);
  }
  [[nodiscard]] int corners() const { return static_cast<int>(corners_.size()); }
  [[nodiscard]] bool line(int segment) const {
    return segment >= static_cast<int>(outline_.segments.size()) ||
           outline_.segments[static_cast<std::size_t>(segment)].kind == DrawnKind::Line;
  }
  [[nodiscard]] int endOf(int segment) const { return outline_.closed ? (segment + 1) % corners() : segment + 1; }
  [[nodiscard]] const Vec2& corner(int k) const { return corners_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Vec2 along(int segment) const { return corner(endOf(segment)) - corner(segment); }
  /// Twice the area within the corners.
  [[nodiscard]] double area() const {
    double sum = 0;
    for (int k = 0; k < corners(); ++k) {
      const Vec2 &a = corner(k), &b = corner((k + 1) % corners());
      sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
  }

 private:
  const DrawnOutline& outline_;
  std::vector<Vec2> corners_;
  bool returns_ = false;
};

bool parallel(const Vec2& a, const Vec2& b) {
  constexpr double alike = 1e-9;
  return std::abs(a.x() * b.y() - a.y() * b.x()) <= alike * a.norm() * b.norm();
}

/// The corners that move when the end of a line does, in order from that end.
std::vector<int> movedCorners(const Ring& ring, int side, const Vec2& by) {
  std::vector<int> moved;
  for (int segment = side;;) {
    const int corner = ring.endOf(segment);
    moved.push_back(corner);
    segment = corner;                              // which starts there
    if (segment >= ring.segments()) return moved;  // the end of an open outline
    const Vec2 along = ring.along(segment);
    const bool takesUp = ring.line(segment) && parallel(along, by) && (along - by).dot(along) > 0;
    if (takesUp) return moved;
    if (ring.endOf(segment) == side) return {ring.endOf(side)};  // around, and nothing took it up
  }
}

DrawnOutline translated(DrawnOutline outline, const Ring& ring, const std::vector<int>& corners, const Vec2& by) {
  std::vector<bool> moves(static_cast<std::size_t>(ring.corners()), false);
  for (const int k : corners) moves[static_cast<std::size_t>(k)] = true;
  const auto moving = [&](int corner) { return moves[static_cast<std::size_t>(corner)]; };
  if (moving(0)) outline.start += by;
  for (int k = 0; k < static_cast<int>(outline.segments.size()); ++k) {
    DrawnSegment& segment = outline.segments[static_cast<std::size_t>(k)];
    if (moving(k) && moving(ring.endOf(k)))
      for (Vec2& p : segment.through) p += by;
    if (moving(ring.endOf(k))) segment.to += by;
  }
  return outline;
}

}  // namespace

std::vector<StraightSide> straightSides(const DrawnOutline& outline) {
  const Ring ring(outline);
  const double turns = ring.area() < 0 ? -1 : 1;
  std::vector<StraightSide> sides;
  for (int k = 0; k < ring.segments(); ++k) {
    const Vec2 along = ring.along(k);
    if (!ring.line(k) || !(along.norm() > 0)) continue;
    sides.push_back({k, ring.corner(k), ring.corner(ring.endOf(k)), turns * Vec2(along.y(), -along.x()).normalized()});
  }
  return sides;
}

std::optional<DrawnOutline> withSideLength(const DrawnOutline& outline, int segment, double length) {
  const Ring ring(outline);
  if (segment < 0 || segment >= ring.segments() || !ring.line(segment)) return std::nullopt;
  const Vec2 along = ring.along(segment);
  if (!(along.norm() > 0) || !(length > 0)) return std::nullopt;
  const Vec2 by = along / along.norm() * (length - along.norm());
  if (by == Vec2::Zero()) return outline;
  DrawnOutline next = tidied(translated(outline, ring, movedCorners(ring, segment, by), by));
  return isSound(next) ? std::optional(std::move(next)) : std::nullopt;
}

}  // namespace blossom::modeling
