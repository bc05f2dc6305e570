#include "manipulators/draw_tool.h"

#include "features_outline_value.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "ui/look/registry_text.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

QString number(double value, const LengthUnit& unit) { return QString::number(value / unit.millimetres, 'g', 6); }

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
  host().select(commitDrawn());
  emit finished();
}

FeatureId DrawTool::commitDrawn() {
  const auto type = host().registry().at("modeling.outline");
  Feature feature = ui::namedFeature(host().document(), *type);
  feature.parameters = completed(type->parameters, parametersOf(draft_.outline()));
  FeatureId id = feature.id;
  host().commit(host().document().with(std::move(feature)), tr("Draw outline"));
  return id;
}

/// The selection stays: it is for the command that ends the drawing.
void DrawTool::conclude() {
  if (draft_.complete()) commitDrawn();
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

}  // namespace blossom::modeling
