#pragma once
#include <optional>

#include "kernel/outline/outline_drawn.h"
#include "kernel/outline/outline_entry.h"
#include "kernel/outline/outline_snap.h"

namespace blossom::modeling {

/// An outline while it is being drawn: a state machine fed with points, keys and typed measures. Knows neither mouse nor
/// screen. A line takes a click for its end; a tangent arc likewise; an arc through three points its end, then a point on
/// it; a spline a click for each point, until another sort of segment is chosen.
class OutlineDraft {
 public:
  /// Strokes that stand.
  [[nodiscard]] const DrawnOutline& outline() const { return outline_; }
  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] bool closed() const { return outline_.closed; }
  /// Can it be finished as it is: is there a stroke?
  [[nodiscard]] bool complete() const { return !outline_.segments.empty(); }

  [[nodiscard]] DrawnKind mode() const { return mode_; }
  [[nodiscard]] bool tangent() const { return tangent_ && direction().has_value(); }
  /// The next segment's sort. The same one again: arcs and splines change between tangent and free; a spline that goes on
  /// ends, and a new one begins.
  void choose(DrawnKind);
  /// The end of a three-point arc stands; the next point lies on it.
  [[nodiscard]] bool wantsMiddle() const { return arcEnd_.has_value(); }

  /// Where the next segment begins, and in which direction the one before arrives there.
  [[nodiscard]] std::optional<Vec2> from() const;
  [[nodiscard]] std::optional<Vec2> direction() const;
  /// Would a click on the first point close the outline?
  [[nodiscard]] bool canClose() const;
  /// What the mouse is caught by besides the scene. @param reach, grid, mouse as in SnapQuery.
  [[nodiscard]] SnapQuery query(const Vec2& mouse, double reach, double grid) const;
  /// The scene with the drawing's own points and lines.
  [[nodiscard]] SnapScene sceneWith(SnapScene others) const;

  /// In which typed lengths without a unit are.
  void setLengthUnit(const LengthUnit& unit) {
    if (unit != entry_.unit()) entry_ = TypedEntry(unit);
  }
  [[nodiscard]] TypedEntry& entry() { return entry_; }
  [[nodiscard]] const TypedEntry& entry() const { return entry_; }

  void hover(const Snap& snap) { hover_ = snap; }
  [[nodiscard]] const std::optional<Snap>& hovered() const { return hover_; }
  /// Where a click would place its point: the hovered one, held to what is typed.
  [[nodiscard]] std::optional<Vec2> target() const;
  /// Adds the target. Nothing happens, and the answer is false, when it determines no segment.
  bool place();
  /// Takes the last point back. @returns whether there was one.
  bool back();
  /// Closes as a click on the first point does; false when it cannot.
  bool close();

  /// The segment that `place` would add, and the outline with it; nothing when the target determines none.
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
