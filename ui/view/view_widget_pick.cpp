// What the mouse finds in the view, and who is told of it: the tool first, then who listens.
#include <vtkActor.h>
#include <vtkRenderer.h>

#include <QKeyEvent>
#include <algorithm>

#include "ui/look/text.h"
#include "ui/view/view_band.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

constexpr double reachOfMouse = 6;  // pixels within which edges and points are met

bool isPartMode(PickMode mode) { return mode != PickMode::Feature && mode != PickMode::None; }

}  // namespace

PickOptions ViewWidget::pickOptions() const {
  const double growth = camera_.pixelGrowth();
  return {.tolerance = growth > 0 ? 0 : reachOfMouse * camera_.millimetresPerPixel(),
          .tolerancePerMm = reachOfMouse * growth,
          .cut = section_};
}

Pick ViewWidget::pickAt(QPointF at, PickMode mode) {
  bringUpToDate();
  return items_.pick(camera_.rayThrough(at), pickOptions(), mode);
}

std::vector<Pick> ViewWidget::picksIn(const QRectF& rect, PickMode mode, bool crossing) {
  bringUpToDate();
  return items_.within(camera_.boundsOf(rect), mode, crossing);
}

void ViewWidget::setPickMode(PickMode mode) {
  if (mode == pickMode_) return;
  pickMode_ = mode;
  setHovered({});
  setSelectedParts({});
}

const std::vector<Pick>& ViewWidget::selectedParts() {
  bringUpToDate();
  return selected_.picks();
}

void ViewWidget::setSelectedParts(const std::vector<Pick>& parts) {
  if (!selected_.set(parts, items_)) return;
  keepGridLast();
  emit partsSelected();
  redraw();
}

void ViewWidget::setTool(Tool* tool, bool handles) {
  if (tool_ && tool_ != tool) disconnect(tool_, nullptr, this, nullptr);
  if (tool && tool_ != tool) connect(tool, &Tool::changed, this, &ViewWidget::showToolProps);
  tool_ = tool;
  handles_ = handles && tool;
  toolHasMouse_ = false;
  setHovered({});
  showToolProps();
}

void ViewWidget::showToolProps() {
  for (const auto& prop : toolProps_) renderer_->RemoveViewProp(prop);
  toolProps_ = tool_ ? tool_->props() : std::vector<vtkSmartPointer<vtkProp>>();
  for (const auto& prop : toolProps_) renderer_->AddViewProp(prop);
  redraw();
}

ToolEvent ViewWidget::toolEvent(QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  bringUpToDate();
  ToolEvent event;
  event.at = at;
  event.ray = camera_.rayThrough(at);
  if (tool_) event.pick = items_.pick(event.ray, pickOptions(), tool_->picks());
  event.button = button;
  event.modifiers = modifiers;
  event.millimetresPerPixel = camera_.millimetresPerPixel();
  return event;
}

// Shortcuts of the window come before the keys of a widget, so a tool is asked already when Qt asks who wants the key.
bool ViewWidget::offerKey(const QKeyEvent& event) {
  keyOffer_ = KeyOffer::None;
  if (!tool_) return false;
  keyOffer_ = KeyOffer::Refused;
  if (tool_->key(event)) {
    keyOffer_ = KeyOffer::Taken;
  } else if (event.key() == Qt::Key_Escape && tool_ && !handles_) {
    keyOffer_ = KeyOffer::Taken;
    emit toolDismissed();
  }
  return keyOffer_ == KeyOffer::Taken;
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
  if (keyOffer_ == KeyOffer::None) offerKey(*event);
  if (std::exchange(keyOffer_, KeyOffer::None) == KeyOffer::Taken)
    event->accept();
  else
    QWidget::keyPressEvent(event);
}

void ViewWidget::hoverAt(QPointF at, Qt::KeyboardModifiers modifiers) {
  const QPointer<Tool> asked = tool_;
  if (tool_) {
    const ToolEvent event = toolEvent(at, Qt::NoButton, modifiers);
    const bool taken = tool_->move(event);
    if (asked == tool_ && tool_ && (taken || !handles_)) {
      setHovered(taken && handles_ ? Pick() : event.pick);
      emit hint(tool_->hint());
      return;
    }
  }
  emit hint(restingHint());
  setHovered(pickAt(at, pickMode_));
}

void ViewWidget::setHovered(const Pick& pick) {
  const bool same = samePart(pick, hovered_);
  hovered_ = pick;
  if (same) return;
  const bool whole = pick.part.kind == SubShapeKind::Whole && (!tool_ || handles_);
  items_.setHovered(whole ? pick.feature : FeatureId());
  hoverLight_.set(pick.part.index < 0 ? std::vector<Pick>() : std::vector<Pick>{pick}, items_);
  keepGridLast();
  emit hovered(hovered_);
  redraw();
}

void ViewWidget::click(QPointF at, Qt::KeyboardModifiers modifiers) {
  if (tool_ && !handles_) return;  // it had its chance
  const Pick pick = pickAt(at, pickMode_);
  emit partPicked(pick, modifiers);
  if (isPartMode(pickMode_))
    selectParts(pick.part.index < 0 ? std::vector<Pick>() : std::vector<Pick>{pick}, modifiers);
  else if (pickMode_ == PickMode::Feature)
    emit picked(qt(pick.feature), modifiers.testFlag(Qt::ControlModifier));
}

// With Ctrl parts are added, and taken away when all of them were selected already; Shift only adds.
void ViewWidget::selectParts(const std::vector<Pick>& parts, Qt::KeyboardModifiers modifiers) {
  const bool toggle = modifiers.testFlag(Qt::ControlModifier), add = toggle || modifiers.testFlag(Qt::ShiftModifier);
  std::vector<Pick> result = add ? selected_.picks() : std::vector<Pick>();
  const auto holds = [&](const Pick& part) {
    return std::any_of(result.begin(), result.end(), [&](const Pick& other) { return samePart(part, other); });
  };
  if (toggle && !parts.empty() && std::all_of(parts.begin(), parts.end(), holds)) {
    std::erase_if(result, [&](const Pick& other) {
      return std::any_of(parts.begin(), parts.end(), [&](const Pick& part) { return samePart(part, other); });
    });
  } else {
    for (const Pick& part : parts)
      if (!holds(part)) result.push_back(part);
  }
  setSelectedParts(result);
}

void ViewWidget::finishBox(QPointF at, Qt::KeyboardModifiers modifiers) {
  band_->hide();
  const QRectF rect = QRectF(pressedAt_, at).normalized();
  const std::vector<Pick> found = picksIn(rect, pickMode_, at.x() < pressedAt_.x());
  emit selectionBoxed(found, modifiers);
  if (isPartMode(pickMode_)) return selectParts(found, modifiers);
  if (pickMode_ != PickMode::Feature) return;
  bool extend = false;
  if (found.empty()) emit picked({}, false);
  for (const Pick& pick : found) emit picked(qt(pick.feature), std::exchange(extend, true));
}

}  // namespace blossom::ui
