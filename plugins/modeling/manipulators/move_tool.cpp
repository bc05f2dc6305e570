#include "manipulators/move_tool.h"

#include <vtkProp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"
#include "feature/registry.h"
#include "geometry/shape/bounds.h"
#include "manipulators/tool_scene.h"
#include "ui/tools/axis_drag.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {
namespace {

constexpr double arrowPixels = 70, shaftFrom = 0.2, middlePixels = 9;
constexpr double grazing = 0.05;  ///< sine of the angle below which the ground is seen from its edge

Vec3 axisOf(std::size_t handle) { return Vec3::Unit(static_cast<Eigen::Index>(handle)); }

}  // namespace

MoveTool::MoveTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

void MoveTool::load() {
  base_ = host().document();
  const Feature& now = base_.at(feature());
  const Value parameters = completed(host().registry().at(now.type)->parameters, now.parameters);
  const Value& move = parameters.at("move");
  for (Eigen::Index k = 0; k < 3; ++k) move_[k] = move.at(static_cast<std::size_t>(k)).get<double>();
  const auto result = host().result(feature());
  if (result && result == result_) {
    // The box of many faces takes a while; of what is not computed anew yet, its place is known.
    if (middleBefore_) *middleBefore_ += move_ - before_;
  } else {
    const Bounds box = result && !result->error ? bounds(result->evaluated.shape) : Bounds();
    middleBefore_ = box.empty ? std::nullopt : std::optional<Vec3>(box.center());
  }
  result_ = result;
  before_ = move_;
}

Document MoveTool::with(const Vec3& move) const {
  Feature changed = base_.at(feature());
  changed.parameters["move"] = Value::array({move.x(), move.y(), move.z()});
  return base_.with(std::move(changed));
}

double MoveTool::arrowLength() const { return arrowPixels * millimetresPerPixel(); }

std::optional<Vec3> MoveTool::placeUnder(std::size_t handle, const Vec3& through, const Ray& ray) const {
  if (handle != middleHandle) return ui::nearestOnLine(ray, through, axisOf(handle));
  const Vec3 along = ray.direction.normalized();
  if (std::abs(along.z()) < grazing) return std::nullopt;
  return Vec3(ray.origin + (through.z() - ray.origin.z()) / along.z() * along);
}

std::optional<std::size_t> MoveTool::handleUnder(const ui::ToolEvent& event) const {
  if (!middleBefore_) return std::nullopt;
  const double reach = gripPixels * event.millimetresPerPixel;
  if (ui::distanceOf(event.ray, middle()) <= reach) return middleHandle;
  for (std::size_t axis = 0; axis < middleHandle; ++axis) {
    const auto place = placeUnder(axis, middle(), event.ray);
    if (!place || ui::distanceOf(event.ray, *place) > reach) continue;
    const double along = (*place - middle()).dot(axisOf(axis));
    if (along > shaftFrom * arrowLength() && along < arrowLength() + reach) return axis;
  }
  return std::nullopt;
}

bool MoveTool::take(std::size_t handle, const ui::ToolEvent& event) {
  load();
  if (!middleBefore_) return false;
  const auto place = placeUnder(handle, *middleBefore_, event.ray);
  if (place) grabbed_ = *place;
  return place.has_value();
}

void MoveTool::drag(const ui::ToolEvent& event) {
  const auto place = placeUnder(*held(), *middleBefore_, event.ray);
  if (!place) return;
  Vec3 wanted = before_ + *place - grabbed_;
  const double step = ui::dragStep(host());
  const bool isStepped = !event.modifiers.testFlag(Qt::ControlModifier);
  for (std::size_t k = 0; k < 3; ++k) {
    const bool isMoved = *held() == k || (*held() == middleHandle && k < 2);
    const auto axis = static_cast<Eigen::Index>(k);
    if (!isMoved) wanted[axis] = before_[axis];
    if (isMoved && isStepped) wanted[axis] = ui::nearestStep(wanted[axis], step);
  }
  if (wanted == move_) return;
  move_ = wanted;
  preview(with(move_));
}

void MoveTool::place() {
  if (move_ != before_) commit(with(move_), tr("Move"));
}

/// "(12 mm, 0 mm, 3 mm)"
QString MoveTool::told() const {
  const auto length = [&](double value) { return QString::fromStdString(formatLength(value, host().lengthUnit())); };
  return QStringLiteral("(%1, %2, %3)").arg(length(move_.x()), length(move_.y()), length(move_.z()));
}

QString MoveTool::hint() const {
  if (held()) return tr("Moved by %1 · Ctrl: no steps · Esc takes it back").arg(told());
  if (!hovered()) return tr("Drag an arrow to move the shape along an axis, the point to move it above the ground");
  return *hovered() == middleHandle ? tr("Drag: move it parallel to the ground") : tr("Drag: move it along the arrow");
}

std::vector<vtkSmartPointer<vtkProp>> MoveTool::props() const {
  if (!middleBefore_) return {};
  const Look& look = host().look();
  const double pixel = host().pixelRatio(), length = arrowLength();
  const auto colorOf = [&](std::size_t handle) { return hovered() == handle ? look.made : look.control; };
  std::vector<vtkSmartPointer<vtkProp>> all;
  const std::array<QString, 3> names{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < middleHandle; ++axis) {
    const Vec3 along = axisOf(axis), tip = middle() + length * along, side = axisOf((axis + 1) % 3),
               other = axisOf((axis + 2) % 3);
    std::vector<std::vector<Vec3>> lines{{middle() + shaftFrom * length * along, tip}};
    for (const Vec3& aside : {side, Vec3(-side), other, Vec3(-other)})
      lines.push_back({tip, tip - length / 7 * along + length / 18 * aside});
    all.push_back(ui::linesProp(lines, colorOf(axis), (hovered() == axis ? 2.5 : 1.75) * pixel));
    all.push_back(ui::labelProp(names.at(axis), tip + length / 12 * along, ui::labelLook(look, colorOf(axis), pixel)));
  }
  all.push_back(
      ui::pointsProp({middle()}, colorOf(middleHandle), (hovered() == middleHandle ? 1.25 : 1) * middlePixels * pixel));
  return all;
}

}  // namespace blossom::modeling
