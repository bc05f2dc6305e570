#include "manipulators/stroke_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <cmath>

#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/curve_through.h"
#include "ui/look/registry_text.h"
#include "ui/tools/view_props.h"

namespace blossom::subdivision {
namespace {

constexpr double freehandPixels = 7;  // between points drawn by hand
constexpr double samePixels = 3;

}  // namespace

StrokeTool::StrokeTool(ui::ToolHost& toolHost) : Tool(toolHost) {
  const std::vector<FeatureId> selected = toolHost.selection();
  if (selected.size() == 1) place_ = deformPlace(toolHost, selected.front());
  if (!place_) return;
  shape_ = selected.front();
  const Bounds extent = bounds(toolHost.result(place_->base)->evaluated.shape);
  flat_ = !extent.empty && extent.low.z() == 0 && extent.high.z() == 0;
}

/// Strokes bulge upwards or sideways: the plane stands upright before the viewer, but seen from above it lies. What lies
/// in the drawing plane is followed there, unless that is seen edge-on.
Vec3 StrokeTool::normal(const ui::ToolEvent& event) const {
  if (axis_) return Vec3::Unit(*axis_);
  const Vec3& d = event.ray.direction;
  constexpr double edgeOn = 0.1;
  if (flat_ && std::abs(d.z()) > edgeOn) return Vec3::UnitZ();
  if (std::abs(d.z()) > 0.9) return Vec3::UnitZ();
  return std::abs(d.x()) > std::abs(d.y()) ? Vec3::UnitX() : Vec3::UnitY();
}

std::optional<Vec3> StrokeTool::placeOf(const ui::ToolEvent& event) const {
  const Vec3 plane = points_.empty() ? normal(event) : normal_;
  const bool inDrawing = flat_ && !axis_ && plane == Vec3::UnitZ();
  Vec3 origin = Vec3::Zero();
  if (inDrawing) {
    // The plane of drawings runs through zero.
  } else if (!points_.empty()) {
    origin = points_.front();
  } else if (!event.pick.feature.empty()) {
    return event.pick.part.point;
  } else if (const Bounds all = host().extent(); !all.empty) {
    origin = all.center();
  }
  const double slope = plane.dot(event.ray.direction);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double along = plane.dot(origin - event.ray.origin) / slope;
  if (along < 0) return std::nullopt;
  Vec3 at = event.ray.origin + along * event.ray.direction;
  if (inDrawing) at.z() = 0;  // without rounding
  return at;
}

void StrokeTool::add(const Vec3& p) {
  if (points_.empty() || (p - points_.back()).norm() > samePixels * pixel_) points_.push_back(p);
}

bool StrokeTool::press(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  pixel_ = event.millimetresPerPixel;
  const auto at = placeOf(event);
  if (!at) return true;
  if (points_.empty()) normal_ = normal(event);
  add(*at);
  drawing_ = true;
  emit changed();
  return true;
}

bool StrokeTool::move(const ui::ToolEvent& event) {
  pixel_ = event.millimetresPerPixel;
  hovered_ = placeOf(event);
  if (drawing_ && hovered_ && (*hovered_ - points_.back()).norm() > freehandPixels * pixel_) add(*hovered_);
  emit changed();
  return drawing_ || event.button == Qt::NoButton;
}

bool StrokeTool::release(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton || !drawing_) return false;
  drawing_ = false;
  return true;
}

bool StrokeTool::doubleClick(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  if (points_.size() > 1) finish();
  return true;
}

bool StrokeTool::key(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  switch (event.key()) {
    case Qt::Key_X:
    case Qt::Key_Y:
    case Qt::Key_Z:
      axis_ = event.key() - Qt::Key_X;
      if (points_.size() < 2) normal_ = Vec3::Unit(*axis_);
      break;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      if (!points_.empty()) points_.pop_back();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      finish();
      return true;
    default:
      return false;
  }
  emit changed();
  return true;
}

void StrokeTool::finish() {
  if (points_.size() < 2) {
    emit finished();
    return;
  }
  Document document = host().document();
  Feature stroke = ui::namedFeature(document, *host().registry().at("subdivision.stroke"));
  stroke.parameters["points"] = Value::array();
  for (const Vec3& p : points_) stroke.parameters["points"].push_back(Value::array({p.x(), p.y(), p.z()}));
  FeatureId shown = stroke.id;
  document = document.with(stroke);
  if (place_) {
    DeformPlace place = *place_;
    if (!place.existing.empty()) {  // a target of its own makes a deformation of its own, on top
      place.base = place.existing;
      place.existing.clear();
    }
    document = withDeform(host(), document, place, Value::object(), {stroke.id}, shown);
  }
  host().commit(std::move(document), place_ ? tr("Pull to a stroke") : tr("Draw a stroke"));
  host().select(shown);
  emit finished();
}

QString StrokeTool::hint() const {
  QStringList parts;
  if (points_.empty())
    parts << (place_ ? tr("Click or draw where the shape is to run") : tr("Click or draw the stroke"));
  else
    parts << tr("Click the next point, or drag to draw");
  if (points_.size() < 2) parts << tr("X, Y, Z: the plane across that axis");
  if (!points_.empty()) parts << tr("Backspace takes back");
  if (points_.size() > 1) parts << (place_ ? tr("Enter pulls the shape to it") : tr("Enter finishes"));
  parts << tr("Esc leaves");
  return parts.join(QStringLiteral(" · "));
}

std::vector<vtkSmartPointer<vtkProp>> StrokeTool::props() const {
  const double ratio = host().pixelRatio();
  const Look& look = host().look();
  std::vector<Vec3> shown = points_;
  if (hovered_ && !drawing_ && !points_.empty() && (*hovered_ - points_.back()).norm() > samePixels * pixel_)
    shown.push_back(*hovered_);
  std::vector<vtkSmartPointer<vtkProp>> props;
  if (shown.size() > 1) {
    const Curve curve = shown.size() > 2 ? splineThrough(shown) : polylineThrough(shown);
    const Tessellation line = tessellate(curve, {.chord = pixel_ / 2});
    props.push_back(ui::linesProp(line.edges, look.made, 2.5 * ratio));
  }
  if (hovered_ && points_.empty()) props.push_back(ui::pointsProp({*hovered_}, look.control, 7 * ratio));
  if (!points_.empty()) props.push_back(ui::pointsProp(points_, look.made, 6 * ratio));
  return props;
}

}  // namespace blossom::subdivision
