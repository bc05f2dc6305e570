// What the factors tool says and draws.
#include <vtkProp.h>

#include <algorithm>

#include "manipulators/factors/axis_colors.h"
#include "manipulators/factors/factors_panel.h"
#include "manipulators/factors/factors_tool.h"
#include "manipulators/motion_lines.h"

namespace blossom::sweep {

namespace {

constexpr double polePixels = 8, chosenPixels = 11, placePixels = 5, combPixels = 60;
constexpr std::size_t framesAround = 8, framesAlong = 7;
constexpr std::size_t mostPlaces = 600, mostBorders = 12;  // more of them would only hide the surface

}  // namespace

QString FactorsTool::hint() const {
  if (!surface_) return tr("The motion is being prepared");
  if (live_ && !live_->possible()) return tr("Nothing will be changed here: %1").arg(live_->reason());
  if (held()) return tr("Let go to move the pole here · Esc takes it back");
  if (!said_.isEmpty()) return said_;
  if (hovered()) {
    const std::size_t count = surface_->motion().trajectory.poles.size();
    if (*hovered() >= count)
      return tr("Drag to move the pole along %1").arg(QStringLiteral("xyz").at(static_cast<qsizetype>(*hovered() - count)));
    return tr("Drag to move the pole in the plane of the view · Shift: choose several · Alt: turn the view");
  }
  if (factor_ == Factor::Trajectory) return tr("Drag a pole of the trajectory, or choose one to move it along an axis");
  return tr("Choose poles in the net and drag them there");
}

bool FactorsTool::draws(bool (FactorsPanel::*shown)() const) const { return panel_ && (panel_->*shown)(); }

std::vector<vtkSmartPointer<vtkProp>> FactorsTool::props() const {
  Props props;
  if (!surface_) return props;
  // Of things at one depth the first is seen.
  if (factor_ == Factor::Trajectory)
    drawTrajectory(props);
  else
    drawPlaces(props);
  props.insert(props.end(), motionProps_.begin(), motionProps_.end());
  return props;
}

void FactorsTool::drawTrajectory(Props& props) const {
  const ui::ToolHost& view = host();
  const double ratio = view.pixelRatio();
  const Color& control = view.look().control;
  const std::vector<Vec3> all = poles();
  std::vector<Vec3> chosen, others;
  for (std::size_t k = 0; k < all.size(); ++k)
    (chosen_.contains({0, k}) || hovered() == k ? chosen : others).push_back(all[k]);
  if (!chosen.empty()) props.push_back(ui::pointsProp(chosen, view.look().made, chosenPixels * ratio));
  if (!others.empty()) props.push_back(ui::pointsProp(others, control, polePixels * ratio));
  if (const auto origin = axesAt())
    for (int k = 0; k < 3; ++k) {
      const bool lit = hovered() == all.size() + static_cast<std::size_t>(k);
      const Vec3 end = *origin + axisLength() * Vec3::Unit(k);
      props.push_back(ui::linesProp({{*origin, end}}, axisSceneColor(k), (lit ? 4.5 : 2.5) * ratio));
      props.push_back(ui::pointsProp({end}, axisSceneColor(k), (lit ? 9 : 6) * ratio));
    }
  props.push_back(ui::linesProp({all}, control, 1.2 * ratio));
  if (!draws(&FactorsPanel::showsCombs)) return;
  const Polylines comb = trajectoryCombLines(motion(), combPixels * millimetresPerPixel());
  if (!comb.empty()) props.push_back(ui::linesProp(comb, mixed(control, view.look().backgroundBottom, 0.35), ratio));
}

void FactorsTool::drawPlaces(Props& props) const {
  const ui::ToolHost& view = host();
  const double ratio = view.pixelRatio();
  const FactorLayout layout = layoutOf(motion(), factor_);
  const auto at = [&](const FactorPole& pole) { return placeHit(motion(), {layout.us[pole.row], layout.vs[pole.column]}); };
  std::vector<Vec3> chosen, others;
  SurfaceLines borders;
  for (const FactorPole& pole : chosen_) {
    if (!layout.contains(pole)) continue;
    const PlaceHit hit = at(pole);
    chosen.push_back(hit.point);
    if (chosen.size() > mostBorders) continue;
    const SurfaceLines border = borderOf(motion(), layout.region(pole), towards_, hit.normal.dot(towards_) >= 0 ? 1 : -1);
    borders.facing.insert(borders.facing.end(), border.facing.begin(), border.facing.end());
  }
  if (layout.rows() * layout.columns() <= mostPlaces)
    for (std::size_t i = 0; i < layout.rows(); ++i)
      for (std::size_t j = 0; j < layout.columns(); ++j)
        if (!chosen_.contains({i, j})) others.push_back(at({i, j}).point);
  if (!chosen.empty()) props.push_back(ui::pointsProp(chosen, view.look().made, chosenPixels * ratio));
  if (!borders.facing.empty()) props.push_back(ui::linesProp(borders.facing, view.look().control, 1.5 * ratio));
  if (!others.empty()) props.push_back(ui::pointsProp(others, view.look().control, placePixels * ratio));
}

std::optional<ui::StandIn> FactorsTool::standIn() const {
  if (live_ && placement_ && (dragged_ || onPanel_)) return live_->mesh().standIn(placement_->users);
  return lingering_ ? std::optional(lingering_->picture()) : std::nullopt;
}

void FactorsTool::drawMotion() {
  motionProps_.clear();
  if (!surface_ || !panel_) return;
  const double ratio = host().pixelRatio();
  if (panel_->showsFrames()) {
    const auto axes = frameLines(motion(), framesAround, framesAlong, 0.4 * suitableAxis(motion()));
    for (int k = 0; k < 3; ++k)
      if (const Polylines& lines = axes[static_cast<std::size_t>(k)]; !lines.empty())
        motionProps_.push_back(ui::linesProp(lines, axisSceneColor(k), 2 * ratio));
  }
  if (panel_->showsIsoCurves())
    motionProps_.push_back(ui::linesProp(knotCurves(motion()), host().look().control, 1.2 * ratio));
}

}  // namespace blossom::sweep
