#pragma once
#include <optional>

#include "geometry/shape/motion_edit.h"
#include "ui/plugin/tool.h"

namespace blossom::sweep {

/// Where the next edit of a swept surface goes.
struct EditPlacement {
  FeatureId source;              ///< the motion to edit: what the sweeps sweep now
  std::vector<FeatureId> users;  ///< the sweeps that are to take the edited motion
};

/// For a selected sweep, or a selected edit of its motion; edits that follow a selected one are followed to the last, which
/// is what is seen. Empty for other features, and while the motion has no result.
std::optional<EditPlacement> editPlacement(const ui::ToolHost&, const FeatureId& selected);

/// Whether the first of the sweeps is to be a solid, so that its ends are closed.
bool makesSolid(const ui::ToolHost&, const EditPlacement&);

/// An edit that the mouse can change.
struct ChangeableEdit {
  FeatureId id;
  MotionEdit edit;
  Shape base, made;         ///< the motion before and after it
  bool isFollowed = false;  ///< by other edits, which are computed anew from what it becomes
};
/// The selected edit, and the last one before the sweep.
std::vector<ChangeableEdit> changeableEdits(const ui::ToolHost&, const EditPlacement&, const FeatureId& selected);

/// What the document is to keep of the goal of an edit that was typed: three coordinates, or an angle.
struct TypedGoal {
  std::size_t place = 0;  ///< of a pull: the one it is the goal of
  Value written;
};

/// The document with one more edit between the motion and its sweeps. A last edit of that type that was begun by the menu
/// and moves nothing yet becomes it.
Document withEdit(const ui::ToolHost&, const EditPlacement&, const MotionEdit&, const std::optional<TypedGoal>& = {});
/// The document with an edit that is there changed; pins and the axis of a pull, which the mouse does not decide, stay.
Document withChangedEdit(const ui::ToolHost&, const FeatureId&, const MotionEdit&, const std::optional<TypedGoal>& = {});

}  // namespace blossom::sweep
