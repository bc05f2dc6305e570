#include "manipulators/radius_tool.h"

#include <vtkProp.h>

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "feature/registry.h"
#include "geometry/bounds.h"
#include "ui/tools/view_props.h"

namespace blossom::morphology {
namespace {

constexpr double gripPixels = 9, ringPixels = 5;
constexpr double smallest = 1e-3;  // mm
constexpr double stepsPerGridSpacing = 20;

QColor qtColor(const Color& color, double opacity) {
  return QColor::fromRgbF(static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue),
                          static_cast<float>(opacity));
}

}  // namespace

RadiusTool::RadiusTool(ui::ToolHost& toolHost, FeatureId feature, Direction direction)
    : Tool(toolHost), feature_(std::move(feature)), direction_(direction) {
  load();
}

void RadiusTool::load() {
  base_ = host().document();
  const Feature& feature = base_.at(feature_);
  radius_ = completed(host().registry().at(feature.type)->parameters, feature.parameters).at("radius").get<double>();
  top_.reset();
  if (feature.inputs.empty()) return;
  const auto solid = host().result(feature.inputs.front());
  if (!solid || solid->error) return;
  const Bounds box = bounds(solid->evaluated.shape);
  if (!box.empty) top_ = Vec3(box.center().x(), box.center().y(), box.high.z());
}

Document RadiusTool::with(double radius) const {
  Feature feature = base_.at(feature_);
  feature.parameters["radius"] = radius;
  return base_.with(std::move(feature));
}

void RadiusTool::documentChanged() {
  if (dragging_ || committing_) return;  // the preview itself
  if (!host().document().contains(feature_)) {
    emit finished();
    return;
  }
  load();
  emit changed();
}

std::optional<double> RadiusTool::heightUnder(const Ray& ray) const {
  const Vec3 across = ray.direction.cross(Vec3::UnitZ());
  if (!top_ || across.norm() < 1e-3 * ray.direction.norm()) return std::nullopt;
  // The plane through the ray and the common normal of both lines meets the vertical there.
  const Vec3 normal = ray.direction.cross(across);
  return (ray.origin - *top_).dot(normal) / normal.z();
}

bool RadiusTool::isUnder(const ui::ToolEvent& event) const {
  if (!top_) return false;
  const Vec3 offset = handle() - event.ray.origin;
  return offset.cross(event.ray.direction.normalized()).norm() <= gripPixels * event.millimetresPerPixel;
}

bool RadiusTool::press(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton || !isUnder(event)) return false;
  const auto height = heightUnder(event.ray);
  if (!height) return false;  // seen from above there is no up and down
  load();
  before_ = radius_;
  grabbed_ = *height - sign() * radius_;
  hovered_ = dragging_ = true;
  emit changed();
  return true;
}

void RadiusTool::drag(const ui::ToolEvent& event) {
  const auto height = heightUnder(event.ray);
  if (!height) return;
  double radius = sign() * (*height - grabbed_);
  if (!event.modifiers.testFlag(Qt::ControlModifier)) {
    const double step = host().gridSpacing() / stepsPerGridSpacing;
    radius = std::max(1.0, std::round(radius / step)) * step;
  }
  radius = std::max(radius, smallest);
  if (radius == radius_) return;
  radius_ = radius;
  host().preview(with(radius));
}

bool RadiusTool::move(const ui::ToolEvent& event) {
  if (dragging_) {
    drag(event);
    emit changed();
    return true;
  }
  const bool under = isUnder(event);
  if (under != hovered_) {
    hovered_ = under;
    emit changed();
  }
  return hovered_ && event.button == Qt::NoButton;
}

bool RadiusTool::release(const ui::ToolEvent& event) {
  if (!dragging_ || event.button != Qt::LeftButton) return false;
  const double made = radius_;
  endDrag();
  if (made != radius_) {
    committing_ = true;  // the host tells of the change before it returns
    host().commit(with(made), tr("Drag the radius"));
    committing_ = false;
    documentChanged();
  } else {
    emit changed();
  }
  return true;
}

void RadiusTool::endDrag() {
  dragging_ = false;
  radius_ = before_;
  host().endPreview();
}

void RadiusTool::revert() {
  if (dragging_) endDrag();
}

bool RadiusTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !dragging_) return false;
  endDrag();
  emit changed();
  return true;
}

QString RadiusTool::hint() const {
  const QString length = QString::fromStdString(formatLength(radius_, host().lengthUnit()));
  if (dragging_) return tr("The radius is %1 · Ctrl: no steps · Esc takes it back").arg(length);
  return hovered_ ? tr("Drag up or down to change the radius of %1").arg(length)
                  : tr("Drag the handle to change the radius");
}

std::vector<vtkSmartPointer<vtkProp>> RadiusTool::props() const {
  if (!top_) return {};
  const Look& look = host().look();
  const Color& color = hovered_ ? look.made : look.control;
  const double pixel = host().pixelRatio();
  const QString length = QString::fromStdString(formatLength(radius_, host().lengthUnit()));
  const Vec3 above = handle().z() > top_->z() ? handle() : *top_;  // beside the line, not on it
  return {
      ui::linesProp({{*top_, handle()}}, color, 1.25 * pixel), ui::pointsProp({*top_}, look.control, ringPixels * pixel),
      ui::pointsProp({handle()}, color, (hovered_ ? 2.4 : 2) * ringPixels * pixel),
      ui::labelProp(length, above, {qtColor(color, 1), qtColor(look.backgroundBottom, 0.85), qtColor(color, 0.5), pixel})};
}

}  // namespace blossom::morphology
