#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "manipulators/insert_edit.h"
#include "manipulators/live_surface.h"
#include "ui/plugin/tool.h"

namespace blossom::sweep {

/// Places that were chosen before a drag: those that go along, and those that stay where they are.
struct ChosenPlaces {
  std::vector<MotionPlace> moved, pinned;

  [[nodiscard]] bool empty() const { return moved.empty() && pinned.empty(); }
  [[nodiscard]] std::vector<MotionPlace> all() const;
  /// Takes the place along, or out again when it was.
  void toggleMoved(const MotionPlace&);
  void togglePinned(const MotionPlace&);
};

/// Where a surface can be taken hold of.
struct PullGrip {
  PlaceHit hit;
  struct OfEdit {
    std::size_t edit, place;
  };
  std::optional<OfEdit> of;  ///< which place of a changeable edit it is
  bool onAxis = false;       ///< of a twist, whose axis is turned
};

/// Whether the axis of an edit, if it has one, is drawn to be turned.
using ShowsAxis = std::function<bool(const ChangeableEdit&)>;

/// What is under the mouse: the end of the axis of a twist among the edits that show theirs, a place that was chosen, or one
/// of a changeable edit, within reach, even beside the surface, as the tip of what was pulled out; else the place of the
/// surface. Places that something else hides or that are cut away are not found.
std::optional<PullGrip> gripUnder(const ui::ToolHost&, const LiveSurface&, const ChosenPlaces&,
                                  const std::vector<ChangeableEdit>&, const ShowsAxis&, const ui::ToolEvent&);

/// The places that an edit moves.
const std::vector<MotionPlace>& editedPlaces(const MotionEdit&);

}  // namespace blossom::sweep
