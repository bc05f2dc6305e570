#include "manipulators/draw_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <QKeySequence>
#include <cmath>

#include "core/angle.h"
#include "features_outline_value.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "manipulators/tool_paint.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

QString number(double value, const LengthUnit& unit) { return QString::number(value / unit.millimetres, 'g', 6); }
QString measure(double value, const LengthUnit& unit) {
  return QStringLiteral("%1 %2").arg(number(value, unit), QString::fromStdString(unit.name));
}

/// "25 mm  30°" for a line, "R 12.5 mm" for an arc, its length for a spline.
QString dimension(const Segment& segment, const LengthUnit& unit) {
  if (const auto* arc = std::get_if<Arc2>(&segment)) return QStringLiteral("R %1").arg(measure(arc->radius, unit));
  if (!std::holds_alternative<Line2>(segment)) return measure(length(segment), unit);
  const Vec2 along = endPoint(segment) - startPoint(segment);
  const double angle = toDegrees(std::atan2(along.y(), along.x()));
  // Half a millionth of a degree of rounding is no news.
  return QStringLiteral("%1   %2°").arg(measure(along.norm(), unit), QString::number(std::round(angle * 1e4) / 1e4));
}

}  // namespace

DrawTool::DrawTool(ui::ToolHost& toolHost) : Tool(toolHost), scene_(snapScene(toolHost, {})) {
  draft_.setLengthUnit(toolHost.lengthUnit());
}

void DrawTool::documentChanged() {
  scene_ = snapScene(host(), {});
  draft_.setLengthUnit(host().lengthUnit());
}

void DrawTool::hover(const ui::ToolEvent& event) {
  millimetresPerPixel_ = event.millimetresPerPixel;
  const auto at = ui::inGround(event.ray);
  if (!at) return;
  // Ctrl lets the mouse go where it is.
  const bool free = event.modifiers.testFlag(Qt::ControlModifier);
  const double reach = free ? 0 : reachPixels * millimetresPerPixel_;
  draft_.hover(free ? Snap{*at, SnapKind::None, {}}
                    : snappedPoint(draft_.sceneWith(scene_), draft_.query(*at, reach, host().gridSpacing())));
}

bool DrawTool::move(const ui::ToolEvent& event) {
  refusal_.clear();
  hover(event);
  emit changed();
  return event.button == Qt::NoButton || event.button == Qt::LeftButton;
}

bool DrawTool::press(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  hover(event);
  place();
  return true;
}

bool DrawTool::release(const ui::ToolEvent& event) { return event.button == Qt::LeftButton; }

bool DrawTool::doubleClick(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  if (draft_.complete() && !draft_.wantsMiddle()) finish();
  return true;
}

void DrawTool::refuse(const QString& why) {
  refusal_ = why;
  emit changed();
}

void DrawTool::place() {
  if (const auto next = draft_.preview(); next && next->closed)
    if (const auto place = selfCrossing(toPath(*next)))
      return refuse(tr("The outline would meet itself at (%1, %2); move a point or take some back with Backspace.")
                        .arg(number(place->x(), host().lengthUnit()), number(place->y(), host().lengthUnit())));
  if (!draft_.place()) {
    const QString problem = QString::fromStdString(draft_.entry().problem());
    return refuse(problem.isEmpty() ? tr("This point makes no segment; choose another.") : problem);
  }
  refusal_.clear();
  undone_.clear();
  if (draft_.closed()) return finish();
  emit changed();
}

void DrawTool::finish() {
  if (!draft_.complete()) {
    emit finished();
    return;
  }
  Feature feature;
  feature.type = "modeling.outline";
  const auto type = host().registry().at(feature.type);
  feature.id = host().document().freshId(type->command);
  feature.name = type->title;
  feature.parameters = completed(type->parameters, parametersOf(draft_.outline()));
  const FeatureId id = feature.id;
  host().commit(host().document().with(std::move(feature)), tr("Draw outline"));
  host().select(id);
  emit finished();
}

bool DrawTool::key(const QKeyEvent& event) {
  refusal_.clear();
  const bool taken = historyKey(event) || entryKey(event) || commandKey(event);
  if (taken) emit changed();
  return taken;
}

QString DrawTool::undoText() const {
  if (draft_.entry().open()) return tr("what is typed");
  return draft_.started() ? tr("the last point") : QString();
}
QString DrawTool::redoText() const { return undone_.empty() ? QString() : tr("the last point"); }

void DrawTool::takeBack() {
  const OutlineDraft before = draft_;
  if (draft_.back()) undone_.push_back(before);
}

void DrawTool::undo() {
  refusal_.clear();
  if (draft_.entry().open()) {
    draft_.entry().clear();
  } else {
    takeBack();
  }
  emit changed();
}

// Where the mouse is now, and what is typed now, is not of the step.
void DrawTool::redo() {
  if (undone_.empty()) return;
  refusal_.clear();
  const auto hovered = draft_.hovered();
  draft_ = undone_.back();
  undone_.pop_back();
  draft_.setLengthUnit(host().lengthUnit());
  draft_.entry().clear();
  if (hovered) draft_.hover(*hovered);
  emit changed();
}

/// The keys of Undo and Redo; where there is no point to take back they are left to the document.
bool DrawTool::historyKey(const QKeyEvent& event) {
  if (event.matches(QKeySequence::Undo) && !undoText().isEmpty()) {
    undo();
    return true;
  }
  const bool again =
      event.matches(QKeySequence::Redo) || (event.key() == Qt::Key_Y && event.modifiers() == Qt::ControlModifier);
  if (!again || redoText().isEmpty()) return false;
  redo();
  return true;
}

/// Keys of a typed measure; they come first while one is open.
bool DrawTool::entryKey(const QKeyEvent& event) {
  TypedEntry& entry = draft_.entry();
  if (entry.open() && event.key() == Qt::Key_Escape) {
    entry.clear();
    return true;
  }
  if (entry.open() && event.key() == Qt::Key_Backspace) return entry.back();
  if (event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab) {
    if (draft_.from() && !draft_.wantsMiddle()) entry.switchField();
    return true;
  }
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  const QByteArray text = event.text().toLatin1();
  if (text.size() != 1) return false;
  // Digits turn the view until there is a point to measure from; "@" begins the place of the first one.
  const bool turnsView = !draft_.started() && !entry.open() && text.at(0) != '@';
  return !turnsView && entry.type(text.at(0));
}

bool DrawTool::commandKey(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  switch (event.key()) {
    case Qt::Key_L:
      draft_.choose(DrawnKind::Line);
      return true;
    case Qt::Key_A:
      draft_.choose(DrawnKind::Arc);
      return true;
    case Qt::Key_S:
      draft_.choose(DrawnKind::Spline);
      return true;
    case Qt::Key_C:
      draft_.hover({draft_.outline().start, SnapKind::Start, {}});
      if (draft_.canClose() && !draft_.wantsMiddle()) place();
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      takeBack();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (draft_.entry().open()) {
        place();
      } else {
        finish();
      }
      return true;
    default:
      return false;
  }
}

QString DrawTool::wanted() const {
  if (!draft_.started()) return tr("Click the first point, or type @ and its x,y");
  if (draft_.wantsMiddle()) return tr("Click a point that the arc passes, or type its radius");
  switch (draft_.mode()) {
    case DrawnKind::Line:
      return tr("Line: click its end, or type a length and, after <, an angle");
    case DrawnKind::Arc:
      return draft_.tangent() ? tr("Tangent arc: click its end; A for three points") : tr("Arc: click its end");
    case DrawnKind::Spline:
      break;
  }
  return tr("Spline: click the next point");
}

QString DrawTool::hint() const {
  if (!refusal_.isEmpty()) return refusal_;
  if (draft_.entry().open()) {
    const QString problem = QString::fromStdString(draft_.entry().problem());
    return tr("Enter places the point, Tab changes between length and angle, Esc leaves the entry") +
           (problem.isEmpty() ? QString() : QStringLiteral(" · ") + problem);
  }
  QStringList parts{wanted()};
  const auto& snap = draft_.hovered();
  if (snap && snap->kind == SnapKind::Start) parts = {tr("Click to close the outline")};
  if (snap && snap->kind != SnapKind::None && snap->kind != SnapKind::Start) parts << snapName(snap->kind);
  if (draft_.started()) parts << tr("L line, A arc, S spline");
  if (draft_.started()) parts << tr("Backspace takes back");
  if (draft_.complete()) parts << tr("Enter finishes");
  parts << tr("Ctrl: no snapping") << tr("Esc leaves");
  return parts.join(QStringLiteral(" · "));
}

void DrawTool::paintDrawn(ToolPaint& paint) const {
  if (!draft_.started()) return;
  if (draft_.complete()) paint.path(toPath(draft_.outline()), paint.look().made);
  paint.square(draft_.outline().start, paint.look().made, !draft_.canClose());
  for (const DrawnSegment& segment : draft_.outline().segments) {
    for (const Vec2& p : segment.through) paint.ring(p, paint.look().made, 3);
    paint.square(segment.to, paint.look().made, true, 3);
  }
}

void DrawTool::paintRubber(ToolPaint& paint) const {
  const auto target = draft_.target();
  const bool typed = draft_.entry().open();
  const auto rubber = target ? draft_.rubber() : std::nullopt;
  if (rubber) paint.segment(*rubber, paint.look().control, 1.5);
  const auto& snap = draft_.hovered();
  if (!snap) return;
  if (typed) {
    // On one card with what it comes to: a second one would lie over it where the segment is short.
    const QString text = QString::fromStdString(draft_.entry().text()) + QStringLiteral(" |");
    const QString comesTo = rubber ? QStringLiteral("   = ") + dimension(*rubber, host().lengthUnit()) : QString();
    paint.label(snap->point, text + comesTo, paint.look().made);
    return;
  }
  QStringList words;
  if (rubber) words << dimension(*rubber, host().lengthUnit());
  for (const Guide& guide : snap->guides) paint.guide(guide, snap->point);
  paint.snapMarker(snap->point, snap->kind);
  if (snap->kind != SnapKind::None && snap->kind != SnapKind::Grid) words << snapName(snap->kind);
  if (!words.isEmpty()) paint.label(snap->point, words.join(QStringLiteral("   ")), paint.look().control);
}

std::vector<vtkSmartPointer<vtkProp>> DrawTool::props() const {
  ToolPaint paint(host().look(), millimetresPerPixel_, host().pixelRatio());
  paintDrawn(paint);
  paintRubber(paint);
  return paint.take();
}

}  // namespace blossom::modeling
