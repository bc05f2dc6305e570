#include "manipulators/tool_paint.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <numbers>

#include "geometry/planar.h"

namespace blossom::modeling {
namespace {

constexpr double fontSize = 13;  // logical pixels

vtkSmartPointer<vtkActor> actorOf(const vtkSmartPointer<vtkPolyData>& data, const Color& color) {
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  // Drawn over whatever lies in front: a drawing is made with the whole of it in sight.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  constexpr double toTheFront = -66000;
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, toTheFront);
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, toTheFront);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

std::vector<Vec2> circleAround(const Vec2& center, double radius) {
  constexpr int sides = 24;
  std::vector<Vec2> points;
  points.reserve(sides + 1);
  for (int k = 0; k <= sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
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
  props_.emplace_back(actor);
}

void ToolPaint::filled(const std::vector<Vec2>& polygon, const Color& color) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell(static_cast<int>(polygon.size()));
  for (const Vec2& p : polygon) cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), 0));
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  props_.emplace_back(actorOf(data, color));
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

void ToolPaint::square(const Vec2& at, const Color& color, bool isFilled, double halfPixels) {
  const double h = halfPixels * pixel_;
  const std::vector<Vec2> corners{at + Vec2(-h, -h), at + Vec2(h, -h), at + Vec2(h, h), at + Vec2(-h, h), at + Vec2(-h, -h)};
  filled({corners.begin(), corners.end() - 1}, isFilled ? color : look_.backgroundBottom);
  lines({corners}, color, 1.5);
}

void ToolPaint::ring(const Vec2& at, const Color& color, double radiusPixels) {
  lines({circleAround(at, radiusPixels * pixel_)}, color, 1.5);
}

void ToolPaint::snapMarker(const Vec2& at, SnapKind kind) {
  const double r = 6 * pixel_;
  const auto p = [&](double x, double y) { return Vec2(at + r * Vec2(x, y)); };
  const auto draw = [&](const std::vector<std::vector<Vec2>>& strokes) { lines(strokes, look_.control, 1.5); };
  switch (kind) {
    case SnapKind::None:
      return;
    case SnapKind::Start:
      draw({circleAround(at, 1.3 * r), circleAround(at, 0.5 * r)});
      return;
    case SnapKind::Point:
      draw({{p(-1, -1), p(1, -1), p(1, 1), p(-1, 1), p(-1, -1)}});
      return;
    case SnapKind::Midpoint:
      draw({{p(-1, -0.8), p(1, -0.8), p(0, 1), p(-1, -0.8)}});
      return;
    case SnapKind::Centre:
      draw({circleAround(at, r), {p(-0.3, 0), p(0.3, 0)}, {p(0, -0.3), p(0, 0.3)}});
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
      draw({circleAround(at, 0.6 * r)});
      return;
  }
}

void ToolPaint::label(const Vec2& at, const QString& text, const Color& color, const Vec2& offsetPixels) {
  const auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  actor->SetInput(text.toUtf8().constData());
  actor->SetPosition(at.x(), at.y(), 0);
  actor->SetDisplayOffset(static_cast<int>(offsetPixels.x() * ratio_), static_cast<int>(offsetPixels.y() * ratio_));
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontSize(static_cast<int>(fontSize * ratio_));
  style->SetColor(color.red, color.green, color.blue);
  const Color& ground = look_.backgroundBottom;
  style->SetBackgroundColor(ground.red, ground.green, ground.blue);
  style->SetBackgroundOpacity(0.75);
  actor->ForceOpaqueOff();
  actor->ForceTranslucentOn();
  actor->PickableOff();
  props_.emplace_back(actor);
}

}  // namespace blossom::modeling
