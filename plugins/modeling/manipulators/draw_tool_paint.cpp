// What a DrawTool shows over the scene: the outline so far, the next segment, and its size or what is typed for it.
#include <vtkProp.h>

#include <cmath>

#include "core/angle.h"
#include "geometry/planar/planar.h"
#include "manipulators/draw_tool.h"
#include "manipulators/tool_paint.h"

namespace blossom::modeling {
namespace {

QString measure(double value, const LengthUnit& unit) {
  return QStringLiteral("%1 %2").arg(QString::number(value / unit.millimetres, 'g', 6), QString::fromStdString(unit.name));
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
