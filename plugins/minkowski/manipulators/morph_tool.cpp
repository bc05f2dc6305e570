#include "manipulators/morph_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "feature/registry.h"
#include "geometry/planar.h"
#include "kernel/control_centre.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double gripPixels = 9, snapPixels = 6, ringPixels = 5;

std::optional<Vec2> groundUnder(const Ray& ray) {
  if (std::abs(ray.direction.z()) < 1e-9) return std::nullopt;
  const double along = -ray.origin.z() / ray.direction.z();
  if (along < 0) return std::nullopt;
  return Vec2((ray.origin + along * ray.direction).head<2>());
}

Vec3 onGround(const Vec2& p) { return {p.x(), p.y(), 0}; }

/// The nearest line of the grid where one is in reach; the place where the shape was drawn is on all of them.
double snappedTo(double value, double spacing, double reach) {
  const double line = std::round(value / spacing) * spacing;
  return std::abs(line - value) <= reach ? line : value;
}

QColor ofQt(const Color& color, double opacity) {
  return QColor::fromRgbF(static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue),
                          static_cast<float>(opacity));
}

ui::LabelLook labelLook(const Look& look, const Color& color, double pixelRatio) {
  return {ofQt(color, 1), ofQt(look.backgroundBottom, 0.85), ofQt(color, 0.5), pixelRatio};
}

}  // namespace

MorphTool::MorphTool(ui::ToolHost& toolHost, FeatureId feature) : Tool(toolHost), feature_(std::move(feature)) {
  // Until the mouse tells better: grid lines are some twenty pixels apart.
  millimetresPerPixel_ = toolHost.gridSpacing() / 20;
  load();
}

void MorphTool::load() {
  base_ = host().document();
  const Feature& feature = base_.at(feature_);
  const auto type = host().registry().at(feature.type);
  controls_.clear();
  for (const FeatureId& input : feature.inputs) {
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
  const Value parameters = completed(type->parameters, feature.parameters);
  const Value& given = parameters.at("offsets");
  for (std::size_t i = 0; i < std::min(given.size(), offsets_.size()); ++i)
    offsets_[i] = {given[i].at(0).get<double>(), given[i].at(1).get<double>()};
}

Vec2 MorphTool::offsetOf(std::size_t shape) const { return offsets_.at(shape); }

Document MorphTool::with(const std::vector<Vec2>& offsets) const {
  std::size_t count = offsets.size();
  while (count > 0 && offsets[count - 1].isZero()) --count;
  Value list = Value::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(Value::array({offsets[i].x(), offsets[i].y(), 0.0}));
  Feature feature = base_.at(feature_);
  feature.parameters["offsets"] = list;
  return base_.with(std::move(feature));
}

void MorphTool::documentChanged() {
  if (dragged_ || committing_) return;  // the preview itself
  if (!host().document().contains(feature_)) {
    emit finished();
    return;
  }
  load();
  if (hovered_ && *hovered_ >= controls_.size()) hovered_.reset();
  emit changed();
}

void MorphTool::commit(const std::vector<Vec2>& offsets, const QString& what) {
  committing_ = true;  // the host tells of the change before it returns
  host().commit(with(offsets), what);
  committing_ = false;
  documentChanged();
}

std::optional<std::size_t> MorphTool::under(const ui::ToolEvent& event) const {
  const auto at = groundUnder(event.ray);
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

bool MorphTool::press(const ui::ToolEvent& event) {
  millimetresPerPixel_ = event.millimetresPerPixel;
  if (event.button != Qt::LeftButton) return false;
  const auto found = under(event);
  if (!found) return false;
  load();
  if (*found >= controls_.size()) return false;
  hovered_ = dragged_ = found;
  before_ = offsets_;
  grabbed_ = *groundUnder(event.ray) - handleOf(*found);
  emit changed();
  return true;
}

void MorphTool::drag(const ui::ToolEvent& event) {
  const auto at = groundUnder(event.ray);
  if (!at) return;
  const std::size_t shape = *dragged_;
  Vec2 offset = *at - grabbed_ - controls_[shape].centre;
  if (!event.modifiers.testFlag(Qt::ControlModifier)) {
    const double spacing = host().gridSpacing(), reach = snapPixels * event.millimetresPerPixel;
    offset = {snappedTo(offset.x(), spacing, reach), snappedTo(offset.y(), spacing, reach)};
  }
  if (offset == offsets_[shape]) return;
  offsets_[shape] = offset;
  host().preview(with(offsets_));
}

bool MorphTool::move(const ui::ToolEvent& event) {
  millimetresPerPixel_ = event.millimetresPerPixel;
  if (dragged_) {
    drag(event);
    emit changed();
    return true;
  }
  const auto found = under(event);
  if (found != hovered_) {
    hovered_ = found;
    emit changed();
  }
  return hovered_.has_value() && event.button == Qt::NoButton;
}

bool MorphTool::release(const ui::ToolEvent& event) {
  if (!dragged_ || event.button != Qt::LeftButton) return false;
  const std::vector<Vec2> made = offsets_;
  const QString name = controls_[*dragged_].name;
  endDrag();
  if (made != offsets_) {
    commit(made, tr("Move %1 in the morph").arg(name));
  } else {
    emit changed();
  }
  return true;
}

bool MorphTool::doubleClick(const ui::ToolEvent& event) {
  const auto found = under(event);
  if (!found) return false;
  load();
  if (*found >= controls_.size() || offsets_[*found].isZero()) return true;
  std::vector<Vec2> offsets = offsets_;
  offsets[*found].setZero();
  commit(offsets, tr("Put %1 back where it was drawn").arg(controls_[*found].name));
  return true;
}

void MorphTool::endDrag() {
  dragged_.reset();
  offsets_ = before_;
  host().endPreview();
}

void MorphTool::revert() {
  if (dragged_) endDrag();
}

bool MorphTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !dragged_) return false;
  endDrag();
  emit changed();
  return true;
}

QString MorphTool::hint() const {
  if (dragged_) {
    const Vec2 offset = offsets_[*dragged_] / host().lengthUnit().millimetres;
    const QString unit = QString::fromStdString(host().lengthUnit().name);
    return tr("%1 is moved by %2, %3 %4 · Ctrl: no snapping · Esc takes it back")
        .arg(controls_[*dragged_].name, QString::number(offset.x(), 'g', 6), QString::number(offset.y(), 'g', 6), unit);
  }
  if (hovered_) {
    const QString& name = controls_[*hovered_].name;
    return offsets_[*hovered_].isZero() ? tr("Drag to move %1 in the morph").arg(name)
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
    const Color& color = i == hovered_ ? look.made : look.control;
    std::vector<std::vector<Vec3>> outlines;
    for (const Path& loop : controls_[i].region.loops) {
      std::vector<Vec3>& line = outlines.emplace_back();
      for (const Vec2& p : flatten(loop, std::max(millimetresPerPixel_ / 4, 1e-6)))
        line.push_back(onGround(p + offsets_[i]));
      line.push_back(line.front());
    }
    props.push_back(ui::linesProp(outlines, color, 1.25 * pixel));
    polygon.push_back(onGround(handleOf(i)));
  }
  if (polygon.size() > 1) props.push_back(ui::linesProp({polygon}, look.control, pixel));
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const Color& color = i == hovered_ ? look.made : look.control;
    props.push_back(ui::pointsProp({polygon[i]}, color, (i == hovered_ ? 2.4 : 2) * ringPixels * pixel));
    props.push_back(ui::labelProp(QString::number(i + 1), polygon[i], labelLook(look, color, pixel)));
  }
  return props;
}

}  // namespace blossom::minkowski
