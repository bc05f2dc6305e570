// What mouse and keys do in the view: the tool is asked first, then the camera moves, or something is found and selected.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/controls/resting_line.h"
#include "ui/look/character_key.h"
#include "ui/look/text.h"
#include "ui/look/units.h"
#include "ui/view/curvature_legend.h"
#include "ui/view/mouse_navigation.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

/// What is typed there is not to go astray because the mouse moves.
bool takesTyping(const QWidget* widget) {
  if (const auto* line = qobject_cast<const QLineEdit*>(widget)) return !rests(*line);
  return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

bool isPartMode(PickMode mode) { return mode != PickMode::Feature && mode != PickMode::None; }

}  // namespace

void ViewWidget::setNavigation(NavigationStyle style) { navigation_->setStyle(style); }

NavigationStyle ViewWidget::navigation() const { return navigation_->style(); }

QString ViewWidget::restingHint() const {
  return tool_ && (!handles_ || tool_->entering()) ? tool_->hint() : idleHint(navigation());
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  event->accept();
  mouseAt_.reset();
  if (secondButton(event)) {
    if (event->button() == Qt::RightButton) leaveDrag();
    return;
  }
  toolHasMouse_ = tool_ && tool_->press(toolEvent(event->position(), event->button(), event->modifiers()));
  pressedAt_ = event->position();
  if (toolHasMouse_)
    navigation_->giveUp();
  else
    startDrag(event->position(), event->buttons(), event->modifiers());
}

// As the right button does while the left one drags.
void ViewWidget::leaveDrag() {
  const QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  if (tool_ && handles_) tool_->key(escape);
}

void ViewWidget::takeDragBack() {
  const QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  if (std::exchange(toolHasMouse_, false) && tool_) tool_->key(escape);
}

// What is dragged stays with the button that took it: neither menus nor the camera come between.
bool ViewWidget::secondButton(const QMouseEvent* event) const {
  return toolHasMouse_ && (event->buttons() & ~Qt::MouseButtons(event->button())) != Qt::NoButton;
}

// A tool says itself what is selected.
void ViewWidget::startDrag(QPointF at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  navigation_->press(at, buttons, modifiers, !tool_ || handles_, [&]() -> std::optional<Vec3> {
    const Pick under = pickAt(at, PickMode::Feature);
    return under.feature.empty() ? std::nullopt : std::optional(under.part.point);
  });
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  mouseAt_ = event->buttons() == Qt::NoButton ? std::optional(at) : std::nullopt;
  // The release may have gone elsewhere: to a dialog that opened meanwhile.
  if (navigation_->pressed() && event->buttons() == Qt::NoButton) navigation_->release();
  if (toolHasMouse_) {
    if (tool_) tool_->move(toolEvent(at, Qt::NoButton, event->modifiers()));
  } else if (navigation_->pressed()) {
    if (navigation_->move(at)) setHovered({});
    return;
  } else {
    hoverAt(at, event->modifiers());
  }
  tellWhereabouts(at);
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (secondButton(event)) return;
  const QPointF at = event->position();
  const bool taken = tool_ && tool_->release(toolEvent(at, event->button(), event->modifiers()));
  const bool ofTool = toolHasMouse_ || taken;
  // Handles may cover all of a shape: where one has nothing to do with a click, the shape is selected.
  const bool leftByHandle =
      toolHasMouse_ && handles_ && !taken && pressedAt_ && (at - *pressedAt_).manhattanLength() < clickReach;
  if (event->buttons() == Qt::NoButton) toolHasMouse_ = false;
  const MouseNavigation::Ended ended = navigation_->release();
  const bool over = event->buttons() == Qt::NoButton && rect().contains(at.toPoint());
  mouseAt_ = over ? std::optional(at) : std::nullopt;
  if (over && handles_)
    hoverAt(at, event->modifiers());
  else
    emit hint(restingHint());
  if (ended == MouseNavigation::Ended::Box) return finishBox(at, event->modifiers());
  if (leftByHandle && event->button() == Qt::LeftButton) return click(at, event->modifiers());
  if (ended != MouseNavigation::Ended::Click || ofTool) return;
  if (event->button() == Qt::LeftButton) click(at, event->modifiers());
  if (event->button() == Qt::RightButton) emit contextMenuWanted(event->globalPosition().toPoint(), pickAt(at, pickMode_));
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  const ToolEvent at = toolEvent(event->position(), event->button(), event->modifiers());
  if (tool_ && (tool_->doubleClick(at) || (tool_ && tool_->press(at)))) {
    toolHasMouse_ = true;
    pressedAt_.reset();
    return;
  }
  if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) fit();
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
  event->accept();
  // With a key that is held down, some systems turn it sideways.
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
  if (tool_ && notches != 0 && tool_->wheel(notches, event->modifiers())) return;
  navigation_->wheel(*event);
  tellWhereabouts(event->position());
}

bool ViewWidget::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (!navigation_->zoomByGesture(gesture) && gesture.gestureType() == Qt::SmartZoomNativeGesture) fit();
    event->accept();
    return true;
  }
  // Nor do commands come between while the mouse is held: Delete would take away what the tool drags or an orbit looks at.
  if (event->type() == QEvent::ShortcutOverride &&
      (offerKey(static_cast<const QKeyEvent&>(*event)) || toolHasMouse_ || navigation_->pressed())) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && offerTab(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

// Widgets never see the key that moves the focus, though a tool may have taken it.
bool ViewWidget::offerTab(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Tab && event.key() != Qt::Key_Backtab) return false;
  if (keyOffer_ == KeyOffer::None) offerKey(event);
  return std::exchange(keyOffer_, KeyOffer::None) == KeyOffer::Taken;
}

// A menu, or another window, gives the focus back.
void ViewWidget::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  const Qt::FocusReason why = event->reason();
  if (tool_ && why != Qt::PopupFocusReason && why != Qt::MenuBarFocusReason && why != Qt::ActiveWindowFocusReason)
    tool_->keysLost();
}

// The right button opens it when it is released without a drag; the key opens it where the mouse is.
void ViewWidget::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
  if (event->reason() == QContextMenuEvent::Keyboard)
    emit contextMenuWanted(event->globalPos(), pickAt(event->pos(), pickMode_));
}

void ViewWidget::leaveEvent(QEvent*) {
  mouseAt_.reset();
  if (tool_ && !toolHasMouse_) tool_->mouseGone();
  setHovered({});
  emit hint({});
  emit whereabouts({});
  legend_->setValue({});
}

void ViewWidget::tellWhereabouts(QPointF at) {
  if (legend_->range()) legend_->setValue(stage_.items().curvatureAt(pickAt(at, PickMode::Face)));
  const Ray ray = camera_.rayThrough(at);
  const QString grid = tr("grid %1").arg(readableLength(stage_.gridSpacing()));
  const std::optional<Vec3> onShape = tool_ ? tool_->whereabouts() : std::nullopt;
  const double reach = std::abs(ray.direction.z()) > 0.05 ? -ray.origin.z() / ray.direction.z() : -1;
  if (!onShape && reach <= 0) {
    emit whereabouts(grid);
    return;
  }
  const Vec3 p = onShape.value_or(ray.origin + ray.direction * reach);
  const LengthUnit& unit = lengthUnit();
  const double perPixel = camera_.millimetresPerPixel() / unit.millimetres;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(perPixel))), 0, 6);
  const auto shown = [&](double value) { return QString::number(value / unit.millimetres, 'f', decimals); };
  const QString name = qt(unit.name);
  emit whereabouts(onShape ? tr("x %1   y %2   z %3 %4").arg(shown(p.x()), shown(p.y()), shown(p.z()), name)
                           : tr("x %1   y %2 %3   ·   %4").arg(shown(p.x()), shown(p.y()), name, grid));
}

Pick ViewWidget::pickAt(QPointF at, PickMode mode) {
  bringUpToDate();
  return stage_.pick(camera_, at, mode);
}

std::vector<Pick> ViewWidget::picksIn(const QRectF& rect, PickMode mode, bool crossing) {
  bringUpToDate();
  return stage_.items().within(camera_.boundsOf(rect), mode, crossing);
}

void ViewWidget::setPickMode(PickMode mode) {
  if (mode == pickMode_) return;
  pickMode_ = mode;
  setHovered({});
  setSelectedParts({});
}

void ViewWidget::setMarkedParts(const MarkedParts& marks) {
  if (stage_.mark(marks)) picture_->redraw();
}

const std::vector<Pick>& ViewWidget::selectedParts() {
  bringUpToDate();
  return stage_.selected();
}

void ViewWidget::setSelectedParts(const std::vector<Pick>& parts) {
  if (!stage_.select(parts)) return;
  emit partsSelected();
  picture_->redraw();
}

void ViewWidget::setTool(Tool* tool, bool handles) {
  if (tool_ && tool_ != tool) disconnect(tool_, nullptr, this, nullptr);
  if (tool && tool_ != tool) connect(tool, &Tool::changed, this, &ViewWidget::markTool);
  tool_ = tool;
  handles_ = handles && tool;
  toolHasMouse_ = false;
  setHovered({});
  markTool();
  if (handles_ && mouseAt_) QMetaObject::invokeMethod(this, &ViewWidget::hoverAgain, Qt::QueuedConnection);
}

// Handles that come under a mouse at rest, as after undo, know where it is without a movement.
void ViewWidget::hoverAgain() {
  if (handles_ && mouseAt_ && !toolHasMouse_ && !navigation_->pressed())
    hoverAt(*mouseAt_, QGuiApplication::queryKeyboardModifiers());
}

// Several movements of the mouse may come before a frame is there. What the mouse moves counts as moving.
void ViewWidget::markTool() {
  toolStale_ = true;
  if (toolHasMouse_)
    picture_->redrawMoving();
  else
    picture_->redraw();
}

void ViewWidget::bringToolUpToDate() {
  if (!std::exchange(toolStale_, false)) return;
  const bool before = stage_.items().hasStandIn();
  stage_.setStandIn(tool_ ? tool_->standIn() : std::nullopt);
  if (stage_.items().hasStandIn() != before)  // not while a picture is painted
    QMetaObject::invokeMethod(this, &ViewWidget::followCurvature, Qt::QueuedConnection);
  stage_.setToolProps(tool_ ? tool_->props() : ViewStage::Props());
}

ToolEvent ViewWidget::toolEvent(QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  bringUpToDate();
  ToolEvent event;
  event.at = at;
  event.ray = camera_.rayThrough(at);
  if (tool_) event.pick = stage_.pick(camera_, at, tool_->picks());
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

bool ViewWidget::takeKeyFromElsewhere(const QKeyEvent& event) {
  if (hasFocus() || !isCharacterKey(event)) return false;
  offerKey(event);
  return std::exchange(keyOffer_, KeyOffer::None) == KeyOffer::Taken;
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
      if (taken && handles_) takeKeys();
      setHovered(taken && handles_ ? Pick() : event.pick);
      emit hint(tool_->hint());
      return;
    }
  }
  emit hint(restingHint());
  setHovered(pickAt(at, pickMode_));
}

// The hint offers keys for the handle under the mouse: they must not go to the tree in which its feature was selected.
void ViewWidget::takeKeys() {
  if (!hasFocus() && isActiveWindow() && !takesTyping(QApplication::focusWidget())) setFocus(Qt::MouseFocusReason);
}

void ViewWidget::setHovered(const Pick& pick) {
  const bool same = samePart(pick, hovered_);
  hovered_ = pick;
  if (same) return;
  const bool whole = pick.part.kind == SubShapeKind::Whole && (!tool_ || handles_);
  stage_.light(pick, whole);
  emit hovered(hovered_);
  picture_->redraw();
}

void ViewWidget::click(QPointF at, Qt::KeyboardModifiers modifiers) {
  if (tool_ && !handles_) return;  // it had its chance
  const Pick pick = pickAt(at, pickMode_);
  emit partPicked(pick, modifiers);
  if (isPartMode(pickMode_)) {
    selectParts(pick.part.index < 0 ? std::vector<Pick>() : std::vector<Pick>{pick}, modifiers);
    // Beside a part there may still be its feature; beside everything nothing stays selected.
    const bool plain = !modifiers.testFlag(Qt::ControlModifier) && !modifiers.testFlag(Qt::ShiftModifier);
    if (plain && pick.feature.empty() && pickAt(at, PickMode::Feature).feature.empty()) emit picked({}, false);
  }
  if (pickMode_ == PickMode::Feature) emit picked(qt(pick.feature), modifiers.testFlag(Qt::ControlModifier));
}

// With Ctrl parts are added, and taken away when all of them were selected already; Shift only adds.
void ViewWidget::selectParts(const std::vector<Pick>& parts, Qt::KeyboardModifiers modifiers) {
  const bool toggle = modifiers.testFlag(Qt::ControlModifier), add = toggle || modifiers.testFlag(Qt::ShiftModifier);
  std::vector<Pick> result = add ? stage_.selected() : std::vector<Pick>();
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
  const std::vector<Pick> found = picksIn(navigation_->box(at), pickMode_, navigation_->crossing(at));
  emit selectionBoxed(found, modifiers);
  if (isPartMode(pickMode_)) return selectParts(found, modifiers);
  if (pickMode_ != PickMode::Feature) return;
  bool extend = false;
  if (found.empty()) emit picked({}, false);
  for (const Pick& pick : found) emit picked(qt(pick.feature), std::exchange(extend, true));
}

}  // namespace blossom::ui
