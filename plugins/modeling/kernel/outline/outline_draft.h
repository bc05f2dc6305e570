#pragma once
#include <optional>

#include "kernel/outline/outline_drawn.h"
#include "kernel/outline/outline_entry.h"
#include "kernel/outline/outline_snap.h"

namespace blossom::modeling {

/// An outline while it is being drawn: a state machine fed with points, keys and typed values, independent of mouse and
/// screen. A line or tangent arc is placed by one click at its end; an arc through three points by its end and then a point
/// on it; a spline by one click per point, until another kind of segment is chosen.
class OutlineDraft {
 public:
  /// The segments placed so far.
  [[nodiscard]] const DrawnOutline& outline() const { return outline_; }
  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] bool closed() const { return outline_.closed; }
  /// Whether it can be finished as it is: it has a segment.
  [[nodiscard]] bool complete() const { return !outline_.segments.empty(); }

  [[nodiscard]] DrawnKind mode() const { return mode_; }
  [[nodiscard]] bool tangent() const { return tangent_ && direction().has_value(); }
  /// Sets the kind of the next segment. Choosing the current kind again toggles arcs and splines between tangent and free,
  /// and ends a spline in progress so that a new one begins.
  void choose(DrawnKind);
  /// Whether the end of a three-point arc is placed and the next point lies on the arc.
  [[nodiscard]] bool wantsMiddle() const { return arcEnd_.has_value(); }

  /// Start point of the next segment, and end direction of the segment before it.
  [[nodiscard]] std::optional<Vec2> from() const;
  [[nodiscard]] std::optional<Vec2> direction() const;
  /// Whether a click on the first point would close the outline.
  [[nodiscard]] bool canClose() const;
  /// The query for snapping to the scene. @param reach, grid, mouse as in SnapQuery.
  [[nodiscard]] SnapQuery query(const Vec2& mouse, double reach, double grid) const;
  /// The scene with the points and lines of the draft added.
  [[nodiscard]] SnapScene sceneWith(SnapScene others) const;

  /// Sets the unit of typed lengths without a unit.
  void setLengthUnit(const LengthUnit& unit) {
    if (unit != entry_.unit()) entry_ = TypedEntry(unit);
  }
  [[nodiscard]] TypedEntry& entry() { return entry_; }
  [[nodiscard]] const TypedEntry& entry() const { return entry_; }

  void hover(const Snap& snap) { hover_ = snap; }
  [[nodiscard]] const std::optional<Snap>& hovered() const { return hover_; }
  /// The point that a click would place: the hovered point, constrained by the typed values.
  [[nodiscard]] std::optional<Vec2> target() const;
  /// Adds the target. Does nothing and returns false when it determines no segment.
  bool place();
  /// Removes the last point. @returns whether there was one.
  bool back();
  /// Closes the outline like a click on the first point; false when that is impossible.
  bool close();

  /// The segment that `place` would add, and the outline with it; empty when the target determines none.
  [[nodiscard]] std::optional<Segment> rubber() const;
  [[nodiscard]] std::optional<DrawnOutline> preview() const;

 private:
  [[nodiscard]] std::optional<DrawnOutline> withPoint(const Vec2&, bool closing) const;
  [[nodiscard]] std::optional<DrawnOutline> withSpline(DrawnOutline, const Vec2&, bool closing) const;
  [[nodiscard]] bool continuesSpline() const;
  [[nodiscard]] bool closes(const Vec2&) const;
  bool placeAt(const Vec2&, bool closing);

  DrawnOutline outline_;
  bool started_ = false;
  DrawnKind mode_ = DrawnKind::Line;
  bool tangent_ = true;
  bool splineGoesOn_ = false;
  std::optional<Vec2> arcEnd_;
  bool arcCloses_ = false;
  std::optional<Snap> hover_;
  TypedEntry entry_;
};

}  // namespace blossom::modeling
