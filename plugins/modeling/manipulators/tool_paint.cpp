#include "manipulators/tool_paint.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>

#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

vtkSmartPointer<vtkActor> actorOf(const vtkSmartPointer<vtkPolyData>& data, const Color& color) {
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  // Drawn over whatever lies in front: a drawing is made with the whole of it in sight.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  constexpr double toTheFront = -66000;
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, toTheFront);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

std::vector<Vec2> circleOf(double radius) {
  constexpr int sides = 24;
  std::vector<Vec2> points;
  points.reserve(sides + 1);
  for (int k = 0; k <= sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace

void ToolPaint::lines(const std::vector<std::vector<Vec2>>& polylines, const Color& color, double width, double opacity) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& polyline : polylines) {
    cells->InsertNextCell(static_cast<int>(polyline.size()));
    for (const Vec2& p : polyline) cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), 0));
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  const auto actor = actorOf(data, color);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width * ratio_));
  actor->GetProperty()->SetOpacity(opacity);
  actor->ForceOpaqueOn();  // blended in place; a pass for translucent things would cost every frame
  props_.emplace_back(actor);
}

void ToolPaint::stamp(const Vec2& at, const Strokes& strokes, const Color& color, bool isFilled) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& stroke : strokes) {
    cells->InsertNextCell(static_cast<int>(stroke.size()));
    for (const Vec2& p : stroke) cells->InsertCellPoint(points->InsertNextPoint(ratio_ * p.x(), ratio_ * p.y(), 0));
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  if (isFilled) {
    data->SetPolys(cells);
  } else {
    data->SetLines(cells);
  }
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(data);
  const auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->GetPositionCoordinate()->SetValue(at.x(), at.y(), 0);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * ratio_));
  actor->PickableOff();
  props_.emplace_back(actor);
}

void ToolPaint::segment(const Segment& segment, const Color& color, double width) {
  lines({flatten(segment, pixel_ / 4)}, color, width);
}

void ToolPaint::path(const Path& path, const Color& color, double width) {
  std::vector<std::vector<Vec2>> polylines;
  polylines.reserve(path.segments.size());
  for (const Segment& segment : path.segments) polylines.push_back(flatten(segment, pixel_ / 4));
  if (!polylines.empty()) lines(polylines, color, width);
}

void ToolPaint::dashed(const Vec2& from, const Vec2& to, const Color& color) {
  const double length = (to - from).norm(), dash = 5 * pixel_;
  if (!(length > 0)) return;
  // A line far longer than the view needs no more dashes than fit in it.
  const double step = std::max(2 * dash, length / 2000);
  const Vec2 along = (to - from) / length;
  std::vector<std::vector<Vec2>> dashes;
  for (double at = 0; at < length; at += step)
    dashes.push_back({from + at * along, from + std::min(at + step / 2, length) * along});
  lines(dashes, color, 1, 0.8);
}

void ToolPaint::guide(const Guide& guide, const Vec2& to) {
  const double along = (to - guide.origin).dot(guide.direction);
  const double beyond = std::copysign(60 * pixel_, along);
  dashed(guide.origin, guide.origin + (along + beyond) * guide.direction, look_.control);
}

void ToolPaint::square(const Vec2& at, const Color& color, bool isFilled, double half) {
  const std::vector<Vec2> corners{{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
  stamp(at, {{corners.begin(), corners.end() - 1}}, isFilled ? color : look_.backgroundBottom, true);
  stamp(at, {corners}, color);
}

void ToolPaint::ring(const Vec2& at, const Color& color, double radius) {
  const std::vector<Vec2> circle = circleOf(radius);
  stamp(at, {{circle.begin(), circle.end() - 1}}, look_.backgroundBottom, true);
  stamp(at, {circle}, color);
}

void ToolPaint::snapMarker(const Vec2& at, SnapKind kind) {
  constexpr double r = 6;
  const auto p = [&](double x, double y) { return Vec2(r * x, r * y); };
  const auto draw = [&](const Strokes& strokes) { stamp(at, strokes, look_.control); };
  switch (kind) {
    case SnapKind::None:
      return;
    case SnapKind::Start:
      draw({circleOf(1.3 * r), circleOf(0.5 * r)});
      return;
    case SnapKind::Point:
      draw({{p(-1, -1), p(1, -1), p(1, 1), p(-1, 1), p(-1, -1)}});
      return;
    case SnapKind::Midpoint:
      draw({{p(-1, -0.8), p(1, -0.8), p(0, 1), p(-1, -0.8)}});
      return;
    case SnapKind::Centre:
      draw({circleOf(r), {p(-0.3, 0), p(0.3, 0)}, {p(0, -0.3), p(0, 0.3)}});
      return;
    case SnapKind::Perpendicular:
      draw({{p(-1, 1), p(-1, -1), p(1, -1)}, {p(-1, 0), p(0, 0), p(0, -1)}});
      return;
    case SnapKind::OnCurve:
      draw({{p(-1, -1), p(1, 1), p(-1, 1), p(1, -1), p(-1, -1)}});
      return;
    case SnapKind::Crossing:
      draw({{p(-1, -1), p(1, 1)}, {p(-1, 1), p(1, -1)}});
      return;
    case SnapKind::Grid:
      draw({{p(-0.8, 0), p(0.8, 0)}, {p(0, -0.8), p(0, 0.8)}});
      return;
    case SnapKind::Horizontal:
    case SnapKind::Vertical:
    case SnapKind::Diagonal:
    case SnapKind::Aligned:
    case SnapKind::Tangent:
    case SnapKind::Square:
      draw({circleOf(0.6 * r)});
      return;
  }
}

void ToolPaint::label(const Vec2& at, const QString& text, const Color& color, const QPointF& shift) {
  ui::LabelLook card = ui::labelLook(look_, color, ratio_);
  card.shift = shift;
  card.border = ui::qtColor(mixed(look_.grid, look_.backgroundBottom, 0.4));
  props_.push_back(ui::labelProp(text, {at.x(), at.y(), 0}, card));
}

void ToolPaint::entry(const Vec2& at, const ui::TypedText& text, const QPointF& shift) {
  if (!text.selected()) return label(at, text.shown(), look_.made, shift);
  ui::LabelLook card = ui::labelLook(look_, look_.backgroundBottom, ratio_);
  card.card = ui::qtColor(look_.made);
  card.border = card.card;
  card.shift = shift;
  props_.push_back(ui::labelProp(text.shown(), {at.x(), at.y(), 0}, card));
}

}  // namespace blossom::modeling
