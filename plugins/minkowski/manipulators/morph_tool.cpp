#include "manipulators/morph_tool.h"

#include <vtkProp.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "feature/registry.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "kernel/control_centre.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double gripPixels = 9, snapPixels = 6, ringPixels = 5;

Vec3 onGround(const Vec2& p) { return {p.x(), p.y(), 0}; }

/// The nearest line of the grid where one is in reach; the place where the shape was drawn is on all of them.
double snappedTo(double value, double spacing, double reach) {
  const double line = std::round(value / spacing) * spacing;
  return std::abs(line - value) <= reach ? line : value;
}

}  // namespace

MorphTool::MorphTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

void MorphTool::load() {
  base_ = host().document();
  const Feature& morph = base_.at(feature());
  const auto type = host().registry().at(morph.type);
  controls_.clear();
  for (const FeatureId& input : morph.inputs) {
    const auto result = host().result(input);
    if (!result || result->error) break;  // handles come when all shapes before them are known
    try {
      const std::vector<Shape> twice(2, result->evaluated.shape);  // read as the feature reads it
      const Region region = arrangedInputs(*type, twice).get<Region>();
      controls_.push_back({region, centreOf(region), QString::fromStdString(base_.at(input).name)});
    } catch (const Error&) {
      break;  // the feature itself says what is wrong with it
    }
  }
  offsets_.assign(controls_.size(), Vec2::Zero());
  const Value parameters = completed(type->parameters, morph.parameters);
  const Value& given = parameters.at("offsets");
  for (std::size_t i = 0; i < std::min(given.size(), offsets_.size()); ++i)
    offsets_[i] = {given[i].at(0).get<double>(), given[i].at(1).get<double>()};
  if (hovered() && *hovered() >= controls_.size()) forgetHovered();
}

Document MorphTool::with(const std::vector<Vec2>& offsets) const {
  std::size_t count = offsets.size();
  while (count > 0 && offsets[count - 1].isZero()) --count;
  Value list = Value::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(Value::array({offsets[i].x(), offsets[i].y(), 0.0}));
  Feature morph = base_.at(feature());
  morph.parameters["offsets"] = list;
  return base_.with(std::move(morph));
}

std::optional<std::size_t> MorphTool::handleUnder(const ui::ToolEvent& event) const {
  const auto at = ui::inGround(event.ray);
  if (!at) return std::nullopt;
  std::optional<std::size_t> best;
  double reach = gripPixels * event.millimetresPerPixel;
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const double distance = (handleOf(i) - *at).norm();
    if (distance > reach) continue;
    reach = distance;
    best = i;
  }
  return best;
}

bool MorphTool::take(std::size_t handle, const ui::ToolEvent& event) {
  load();
  if (handle >= controls_.size()) return false;
  before_ = offsets_;
  grabbed_ = *ui::inGround(event.ray) - handleOf(handle);
  return true;
}

void MorphTool::drag(const ui::ToolEvent& event) {
  const auto at = ui::inGround(event.ray);
  if (!at) return;
  const std::size_t shape = *held();
  Vec2 offset = *at - grabbed_ - controls_[shape].centre;
  if (!event.modifiers.testFlag(Qt::ControlModifier)) {
    const double spacing = host().gridSpacing(), reach = snapPixels * event.millimetresPerPixel;
    offset = {snappedTo(offset.x(), spacing, reach), snappedTo(offset.y(), spacing, reach)};
  }
  if (offset == offsets_[shape]) return;
  offsets_[shape] = offset;
  preview(with(offsets_));
}

void MorphTool::place() {
  if (offsets_ != before_) commit(with(offsets_), tr("Move %1 in the morph").arg(controls_[*held()].name));
}

bool MorphTool::doubleClick(const ui::ToolEvent& event) {
  const auto found = handleUnder(event);
  if (!found) return false;
  load();
  if (*found >= controls_.size() || offsets_[*found].isZero()) return true;
  std::vector<Vec2> offsets = offsets_;
  offsets[*found].setZero();
  commit(with(offsets), tr("Put %1 back where it was drawn").arg(controls_[*found].name));
  return true;
}

QString MorphTool::hint() const {
  if (held()) {
    const Vec2 offset = offsets_[*held()] / host().lengthUnit().millimetres;
    const QString unit = QString::fromStdString(host().lengthUnit().name);
    return tr("%1 is moved by %2, %3 %4 · Ctrl: no snapping · Esc takes it back")
        .arg(controls_[*held()].name, QString::number(offset.x(), 'g', 6), QString::number(offset.y(), 'g', 6), unit);
  }
  if (hovered()) {
    const QString& name = controls_[*hovered()].name;
    return offsets_[*hovered()].isZero() ? tr("Drag to move %1 in the morph").arg(name)
                                         : tr("Drag to move %1 in the morph · double click puts it back").arg(name);
  }
  return tr("Drag the centre of a control shape to move it");
}

std::vector<vtkSmartPointer<vtkProp>> MorphTool::props() const {
  std::vector<vtkSmartPointer<vtkProp>> props;
  const double pixel = host().pixelRatio();
  const Look& look = host().look();
  std::vector<Vec3> polygon;
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const Color& color = i == hovered() ? look.made : look.control;
    std::vector<std::vector<Vec3>> outlines;
    // The handles may be made before the view has come near.
    const double chord = 2e-4 * bounds(Shape(controls_[i].region)).diagonal();
    for (const Path& loop : controls_[i].region.loops) {
      std::vector<Vec3>& line = outlines.emplace_back();
      for (const Vec2& p : flatten(loop, std::clamp(millimetresPerPixel() / 4, 1e-6, std::max(chord, 1e-6))))
        line.push_back(onGround(p + offsets_[i]));
      line.push_back(line.front());
    }
    props.push_back(ui::linesProp(outlines, color, 1.25 * pixel));
    polygon.push_back(onGround(handleOf(i)));
  }
  if (polygon.size() > 1) props.push_back(ui::linesProp({polygon}, look.control, pixel));
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const Color& color = i == hovered() ? look.made : look.control;
    props.push_back(ui::pointsProp({polygon[i]}, color, (i == hovered() ? 2.4 : 2) * ringPixels * pixel));
    props.push_back(ui::labelProp(QString::number(i + 1), polygon[i], ui::labelLook(look, color, pixel)));
  }
  return props;
}

}  // namespace blossom::minkowski
