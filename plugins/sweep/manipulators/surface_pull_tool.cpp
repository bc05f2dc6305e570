// What the mouse does, and what becomes of it in the document.
#include "manipulators/surface_pull_tool.h"

#include <vtkProp.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace blossom::sweep {

SurfacePullTool::SurfacePullTool(ui::ToolHost& toolHost, FeatureId feature)
    : HandleTool(toolHost, std::move(feature)), mode_(toolHost.kept<PullMode>()) {
  load();
}

void SurfacePullTool::load() {
  if (lingering_ && lingering_->over(host())) lingering_.reset();
  placement_ = editPlacement(host(), feature());
  unseen_ = placement_ && placement_->users.empty();
  if (unseen_) placement_.reset();  // a drag would change nothing that is seen
  edits_ = placement_ ? changeableEdits(host(), *placement_, feature()) : std::vector<ChangeableEdit>();
  const bool ofEdit = under_ && under_->of;
  if (ofEdit) under_.reset();  // its number was that of an edit before
  const bool earlier = !edits_.empty() && edits_.front().isFollowed;
  if (selectedLoader_.load(earlier ? edits_.front().made : Shape())) selectedSurface_.reset();
  const Shape motion = placement_ ? host().result(placement_->source)->evaluated.shape : Shape();
  if (loader_.load(motion))
    show(nullptr);
  else if (ofEdit && surface_)
    lookAgain();
}

void SurfacePullTool::show(std::shared_ptr<const LiveSurface> surface) {
  surface_ = std::move(surface);
  under_.reset();
  chosen_ = {};
  stopTyping();
  forgetHovered();
  if (surface_ && early_) takeEarlyPress();
  if (surface_) lookAgain();
  emit changed();
}

/// After an edit the surface takes a moment to be computed and prepared for the next one. A press on it meanwhile is not for
/// the camera: who goes on pulling would find the view turned.
bool SurfacePullTool::comesEarly(const ui::ToolEvent& event) const {
  if (surface_ || event.button != Qt::LeftButton || event.modifiers & (Qt::ControlModifier | Qt::AltModifier)) return false;
  // The point that was pulled is under the mouse, also where it makes an outline that its picture misses by a hair.
  const bool rests = (event.at - letGoAt_).manhattanLength() < ui::clickReach;
  if (lingering_) return rests || lingering_->isHit(event.ray);
  return loader_.busy() && placement_ && std::ranges::count(placement_->users, event.pick.feature) > 0;
}

/// Pulls from where the button went down to where the mouse is by now.
void SurfacePullTool::takeEarlyPress() {
  const ui::ToolEvent pressed = *std::exchange(early_, std::nullopt), now = mouse_.value_or(pressed);
  if (press(pressed)) move(now);
}

bool SurfacePullTool::press(const ui::ToolEvent& event) {
  if (comesEarly(event)) {
    mouse_ = early_ = event;
    return true;
  }
  if (!held()) {
    if (entry_) {
      stopTyping();
      emit changed();
    }
    look(event);
  }
  return HandleTool::press(event);
}

bool SurfacePullTool::move(const ui::ToolEvent& event) {
  if (held() || early_) {
    mouse_ = event;
    return HandleTool::move(event);
  }
  if (entry_) return event.button == Qt::NoButton;  // the place whose goal is typed stays
  look(event);
  const bool taken = HandleTool::move(event);
  if (hovered()) emit changed();  // another place, though the same handle
  return taken;
}

void SurfacePullTool::mouseGone() {
  if (held() || entry_) return;  // the place whose goal is typed stays
  mouse_.reset();
  under_.reset();
  overSurface_ = false;
  HandleTool::mouseGone();
}

/// A click is for the view, which selects what is there; with Shift it takes the place along.
bool SurfacePullTool::release(const ui::ToolEvent& event) {
  mouse_ = event;
  letGoAt_ = event.at;
  early_.reset();
  const bool dragged = dragged_, typing = entry_.has_value();
  const bool chooses = held() && !dragged && !typing && event.modifiers.testFlag(Qt::ShiftModifier);
  if (!HandleTool::release(event)) return false;
  if (chooses && under_ && !under_->onAxis) {
    chosen_.toggleMoved(under_->hit.at);
    emit changed();
  }
  return dragged || typing || chooses;
}

/// Where the mouse was let go, as a rule: it need not move for the place under it to be shown. In a view that was turned or
/// zoomed since, the ray of that event is no longer under the mouse.
void SurfacePullTool::lookAgain() {
  if (!mouse_ || held()) return;
  const ui::ToolEvent event = *mouse_;
  look(event);
  if (!under_) return forgetHovered();
  const auto seen = host().onScreen(event.ray.origin + under_->hit.distance * event.ray.direction);
  if (seen && (*seen - event.at).manhattanLength() < 1)
    HandleTool::move(event);
  else
    under_.reset(), forgetHovered();
}

void SurfacePullTool::look(const ui::ToolEvent& event) {
  mouse_ = event;
  towards_ = event.ray.direction;
  under_.reset();
  // With Ctrl or Alt the mouse is for the view, so that the surface and its parts can still be selected and turned.
  if (!surface_ || event.modifiers & (Qt::ControlModifier | Qt::AltModifier)) return;
  under_ = gripUnder(
      host(), *surface_, chosen_, edits_, [this](const ChangeableEdit& each) { return showsAxis(each); }, event);
  overSurface_ = under_.has_value();
}

std::optional<std::size_t> SurfacePullTool::handleUnder(const ui::ToolEvent&) const {
  if (!under_) return std::nullopt;
  if (under_->onAxis) return axisOfEdit;
  return under_->of ? placeOfEdit : anyPlace;
}

bool SurfacePullTool::take(std::size_t /*handle*/, const ui::ToolEvent& event) {
  const auto grip = gripToHold();
  if (!grip) return false;
  hold(*grip, DragTarget(grip->hit, event), event.millimetresPerPixel);
  pressedAt_ = event.at;
  return edit_ != nullptr;
}

std::optional<PullGrip> SurfacePullTool::gripToHold() const {
  if (!under_ || !isFollowed(*under_)) return under_;
  if (!selectedSurface_) return std::nullopt;
  return PullGrip{placeHit(selectedSurface_->motion(), under_->hit.at), under_->of, under_->onAxis};
}

void SurfacePullTool::hold(const PullGrip& grip, const DragTarget& target, double pixel) {
  const auto changed = grip.of ? std::optional(edits_[grip.of->edit]) : std::nullopt;
  const std::shared_ptr<const LiveSurface>& surface = isFollowed(grip) ? selectedSurface_ : surface_;
  const auto ball = grip.onAxis && changed ? axisBall(surface->motion(), changed->edit, pixel) : std::nullopt;
  try {
    edit_ = std::make_unique<HeldEdit>(HeldEdit::Start{surface, grip, chosen_, changed, target, pixel,
                                                       placement_ && makesSolid(host(), *placement_), ball});
  } catch (const Error&) {
    edit_.reset();  // the motion that it changes is wrong, which its feature tells
  }
  dragged_ = false;
}

void SurfacePullTool::drag(const ui::ToolEvent& event) {
  if (entry_ || !edit_) return;  // the goal is typed, or was
  dragged_ = dragged_ || (event.at - pressedAt_).manhattanLength() >= ui::clickReach;
  if (!dragged_) return;
  edit_->follow(event);
  follow();
}

void SurfacePullTool::follow() {
  if (edit_ && (dragged_ || entry_)) edit_->show(mode_);
}

void SurfacePullTool::place() {
  if (!entry_ && edit_ && dragged_ && edit_->changesAnything(mode_) && edit_->possible()) commitEdit({});
}

/// What is seen stays until the sweep is computed.
void SurfacePullTool::commitEdit(const std::optional<TypedGoal>& typed) {
  const std::unique_ptr<HeldEdit> done = std::move(edit_);
  std::optional<LingeringPicture> lingering;
  lingering.emplace(host(), done->live().mesh().standIn(placement_->users));
  const MotionEdit edit = done->edit(mode_);
  const QString what = done->turnsAxis() && !typed ? tr("Turn the axis of a twist")
                       : done->twists(mode_)       ? tr("Twist the surface")
                                                   : tr("Pull the surface");
  commit(done->changesOne(mode_) ? withChangedEdit(host(), done->changed().id, edit, typed)
                                 : withEdit(host(), *placement_, edit, typed),
         what);
  lingering->begin(host());
  if (!lingering->over(host())) lingering_ = std::move(lingering);
  chosen_ = {};
}

void SurfacePullTool::putBack() {
  dragged_ = false;
  if (!entry_) edit_.reset();  // typing goes on without the button
}

std::optional<ui::StandIn> SurfacePullTool::standIn() const {
  if (edit_ && placement_ && (dragged_ || entry_)) return edit_->live().mesh().standIn(placement_->users);
  return lingering_ ? std::optional(lingering_->picture()) : std::nullopt;
}

}  // namespace blossom::sweep
