#include "manipulators/radius_tool.h"

#include <vtkProp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "feature/registry.h"
#include "geometry/shape/bounds.h"
#include "ui/tools/axis_drag.h"
#include "ui/tools/view_props.h"

namespace blossom::morphology {
namespace {

constexpr double gripPixels = 9, ringPixels = 5;
constexpr double smallest = 1e-3;  // mm

}  // namespace

RadiusTool::RadiusTool(ui::ToolHost& toolHost, FeatureId feature, Direction direction)
    : HandleTool(toolHost, std::move(feature)), direction_(direction) {
  load();
}

void RadiusTool::load() {
  base_ = host().document();
  const Feature& now = base_.at(feature());
  const Value parameters = completed(host().registry().at(now.type)->parameters, now.parameters);
  radius_ = parameters.at("radius").get<double>();
  top_.reset();
  const bool isUsed = now.inputs.size() == 1 && parameters.value("until", "size") == "size";
  if (!isUsed) return;
  const auto solid = host().result(now.inputs.front());
  if (!solid || solid->error) return;
  const Bounds box = bounds(solid->evaluated.shape);
  if (!box.empty) top_ = Vec3(box.center().x(), box.center().y(), box.high.z());
}

Document RadiusTool::with(double radius) const {
  Feature changed = base_.at(feature());
  changed.parameters["radius"] = radius;
  return base_.with(std::move(changed));
}

std::optional<double> RadiusTool::heightUnder(const Ray& ray) const {
  if (!top_) return std::nullopt;
  const auto place = ui::nearestOnLine(ray, *top_, Vec3::UnitZ());
  if (!place) return std::nullopt;
  return place->z() - top_->z();
}

std::optional<std::size_t> RadiusTool::handleUnder(const ui::ToolEvent& event) const {
  if (!top_) return std::nullopt;
  const bool isNear = ui::distanceOf(event.ray, handle()) <= gripPixels * event.millimetresPerPixel;
  return isNear ? std::optional<std::size_t>(0) : std::nullopt;
}

bool RadiusTool::take(std::size_t /*handle*/, const ui::ToolEvent& event) {
  load();
  const auto height = heightUnder(event.ray);
  if (!height) return false;  // seen from above there is no up and down
  before_ = radius_;
  grabbed_ = *height - sign() * radius_;
  return true;
}

void RadiusTool::drag(const ui::ToolEvent& event) {
  const auto height = heightUnder(event.ray);
  if (!height) return;
  double radius = sign() * (*height - grabbed_);
  if (!event.modifiers.testFlag(Qt::ControlModifier)) {
    const double step = ui::dragStep(host());
    radius = ui::nearestStep(std::max(radius, step), step);
  }
  radius = std::max(radius, smallest);
  if (radius == radius_) return;
  radius_ = radius;
  preview(with(radius));
}

void RadiusTool::place() {
  if (radius_ != before_) commit(with(radius_), tr("Drag the radius"));
}

QString RadiusTool::hint() const {
  if (!top_) return {};
  const QString length = QString::fromStdString(formatLength(radius_, host().lengthUnit()));
  if (held()) return tr("The radius is %1 · Ctrl: no steps · Esc takes it back").arg(length);
  return hovered() ? tr("Drag up or down to change the radius of %1").arg(length)
                   : tr("Drag the handle to change the radius");
}

std::vector<vtkSmartPointer<vtkProp>> RadiusTool::props() const {
  if (!top_) return {};
  const Look& look = host().look();
  const Color& color = hovered() ? look.made : look.control;
  const double pixel = host().pixelRatio();
  const QString length = QString::fromStdString(formatLength(radius_, host().lengthUnit()));
  const Vec3 above = handle().z() > top_->z() ? handle() : *top_;  // beside the line, not on it
  return {ui::linesProp({{*top_, handle()}}, color, 1.25 * pixel), ui::pointsProp({*top_}, look.control, ringPixels * pixel),
          ui::pointsProp({handle()}, color, (hovered() ? 2.4 : 2) * ringPixels * pixel),
          ui::labelProp(length, above, ui::labelLook(look, color, pixel))};
}

}  // namespace blossom::morphology
