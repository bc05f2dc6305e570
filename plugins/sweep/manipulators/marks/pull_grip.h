#pragma once
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
};

/// What is under the mouse: a place that was chosen, or one of a changeable edit, within reach, even beside the surface, as
/// the tip of what was pulled out; else the place of the surface. Empty where something else hides it or it is cut away.
std::optional<PullGrip> gripUnder(const ui::ToolHost&, const LiveSurface&, const ChosenPlaces&,
                                  const std::vector<ChangeableEdit>&, const ui::ToolEvent&);

/// The places that an edit moves.
const std::vector<MotionPlace>& editedPlaces(const MotionEdit&);

}  // namespace blossom::sweep
