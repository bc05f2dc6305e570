// The keys of the surface pull tool: ways of pulling, places that are chosen, and goals that are typed.
#include <vtkProp.h>

#include <QKeyEvent>
#include <utility>

#include "core/error.h"
#include "manipulators/surface_pull_tool.h"

namespace blossom::sweep {

bool SurfacePullTool::key(const QKeyEvent& event) {
  if (entry_) return typingKey(event);
  if (event.key() == Qt::Key_Escape && std::exchange(early_, std::nullopt)) return true;
  if (HandleTool::key(event)) {
    lookAgain();  // the mouse has gone on since it took the place
    emit changed();
    return true;
  }
  const bool plain = !event.modifiers().testFlag(Qt::ControlModifier) &&
                     (held() || !(event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)));
  if (!plain) return false;
  if (!surface_) return keyWhilePreparing(event);
  const bool ready = hovered() || held() || overSurface_;  // the mouse need not have moved since the last edit
  const bool chooses = held() || !event.modifiers().testFlag(Qt::ShiftModifier);
  if (!(chooses && chooseKey(event.key())) && !(ready && keyOfMode(event))) return false;
  if (!entry_) follow();
  if (!entry_ && !held()) lookAgain();  // the axis of a twist may have come or gone
  emit changed();
  return true;
}

/// During a drag, Shift is for its direction; on many keyboards it is what makes a plus.
bool SurfacePullTool::keyOfMode(const QKeyEvent& event) {
  if (held() || event.key() == Qt::Key_Plus || !event.modifiers().testFlag(Qt::ShiftModifier)) return mode_.key(event.key());
  return mode_.keyWithShift(event.key());
}

/// The camera has it, unless Shift is held down over the surface; during a drag it stays where it is.
bool SurfacePullTool::wheel(double notches, Qt::KeyboardModifiers modifiers) {
  const bool meant = held() || (hovered() && modifiers.testFlag(Qt::ShiftModifier));
  if (!meant || modifiers & (Qt::ControlModifier | Qt::AltModifier) || mode_.adjustable().isEmpty()) return false;
  notches_ += notches;
  const int whole = static_cast<int>(notches_);
  notches_ -= whole;
  if (whole == 0) return true;
  mode_.addTenths(whole);
  follow();
  emit changed();
  return true;
}

/// After an edit the surface takes a moment to be ready for the next one. Who goes on meanwhile does not mean the keys of
/// the view.
bool SurfacePullTool::keyWhilePreparing(const QKeyEvent& event) {
  if (!overSurface_ || !loader_.busy() || !keyOfMode(event)) return false;
  emit changed();
  return true;
}

/// Pins the place under the mouse, forgets all that were chosen, begins to type the goal.
bool SurfacePullTool::chooseKey(int key) {
  if (key == Qt::Key_Escape && !chosen_.empty()) {
    chosen_ = {};
    return true;
  }
  if (!under_ || !(hovered() || held())) return false;
  if (key == Qt::Key_P && !held() && !under_->onAxis) {
    chosen_.togglePinned(under_->hit.at);
    return true;
  }
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && (edit_ || !held())) {
    startTyping();
    return true;
  }
  return false;
}

void SurfacePullTool::keysLost() {
  if (!entry_) return;
  stopTyping();
  emit changed();
}

void SurfacePullTool::startTyping() {
  if (!edit_) {
    const auto grip = gripToHold();
    if (!grip) return;
    hold(*grip, DragTarget(grip->hit, towards_), millimetresPerPixel());
    if (!edit_) return;
  }
  refusal_.clear();
  entry_ = edit_->twists(mode_) ? GoalEntry::ofAngle(edit_->angle(mode_)) : GoalEntry::ofPoint(host(), edit_->goal());
  follow();
}

bool SurfacePullTool::typingKey(const QKeyEvent& event) {
  const ui::TypedKey key = entry_->key(event);
  if (key == ui::TypedKey::Other) return false;
  if (key == ui::TypedKey::Leave) stopTyping();
  if (key == ui::TypedKey::Take) takeTyped();
  if (key == ui::TypedKey::Text) followTyped();
  emit changed();
  return true;
}

/// As far as it can be understood; half a number need not be. Before it is ready, nothing is missing.
void SurfacePullTool::followTyped(bool ready) {
  refusal_.clear();
  try {
    if (entry_->unchanged()) {
      edit_->forgetTyped();
      return follow();
    }
    const GoalEntry::Goal goal = ready ? entry_->goal(host()) : entry_->goalSoFar(host());
    if (entry_->isAngle())
      edit_->turnTo(goal.angle);
    else
      edit_->aimAt(goal.point);
    follow();
  } catch (const Error& error) {
    refusal_ = QString::fromStdString(error.message());
  }
}

void SurfacePullTool::takeTyped() {
  followTyped(true);
  if (!refusal_.isEmpty()) return;
  if (!edit_->changesAnything(mode_)) return stopTyping();
  if (!edit_->possible()) {
    refusal_ = edit_->live().reason();
    return;
  }
  std::optional<TypedGoal> typed;
  if (!entry_->unchanged()) typed = TypedGoal{edit_->changesOne(mode_) ? edit_->place() : 0, entry_->goal(host()).written};
  entry_.reset();
  commitEdit(typed);
}

/// The mouse decides again, if its button is still down.
void SurfacePullTool::stopTyping() {
  if (!entry_) return;
  entry_.reset();
  refusal_.clear();
  if (edit_) edit_->forgetTyped();
  if (held())
    follow();
  else
    edit_.reset();
}

}  // namespace blossom::sweep
