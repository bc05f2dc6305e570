#include "manipulators/pull_marks.h"

#include <vtkProp.h>

#include <algorithm>

#include "kernel/edit/motion_symmetry.h"
#include "manipulators/live_net.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t netEvery = 4;                  // rows of the live grid
constexpr double axisPixels = 90, twistRadius = 40;  // half the length of an axis; the arc of a point on it
constexpr double pointPixels = 10, copyPixels = 8;

}  // namespace

void PullMarks::lines(const std::vector<std::vector<Vec3>>& all, const Color& color, double width) {
  if (!all.empty()) props_.push_back(ui::linesProp(all, color, width * host_.pixelRatio()));
}

/// Beside the background: what is idle, or on the far side.
Color PullMarks::faint(const Color& color) const {
  constexpr double share = 0.6;
  return mixed(color, host_.look().backgroundBottom, share);
}

void PullMarks::surfaceLines(const SurfaceLines& all, double width) {
  const Color& control = host_.look().control;
  lines(all.averted, faint(control), 0.7 * width);
  lines(all.facing, control, width);
}

void PullMarks::place(const Motion& motion, const PlaceHit& hit, const PullMode& mode, const Vec3& towards) {
  const double side = hit.normal.dot(towards) >= 0 ? 1 : -1;
  surfaceLines(borderOf(motion, editRegion(motion, hit.at, mode), towards, side), 1);
  surfaceLines(isoCurvesThrough(motion, hit.at, towards, side), 1.8);
  props_.push_back(ui::pointsProp({hit.point}, host_.look().control, pointPixels * host_.pixelRatio()));
}

void PullMarks::copies(const std::vector<Vec3>& all) {
  if (!all.empty()) props_.push_back(ui::pointsProp(all, host_.look().control, copyPixels * host_.pixelRatio()));
}

void PullMarks::ring(const Vec3& centre, const PullMode& mode) {
  const RingLines ring = ringLines(centre, facing_, mode.weights());
  lines(ring.idle, mixed(host_.look().control, host_.look().backgroundBottom, 0.4), 2);
  lines(ring.active, host_.look().made, 2.5);
  lines(ring.border, host_.look().backgroundBottom, 1);
}

void PullMarks::twist(const Vec3& centre, const Vec3& axis, const Vec3& arm, const std::optional<double>& degrees) {
  const double pixel = facing_.pixel;
  const auto all = twistLines(centre, axis, arm, degrees.value_or(0), axisPixels * pixel, twistRadius * pixel);
  lines({all.front()}, host_.look().control, 2);
  if (!degrees) return;
  lines({all.back()}, host_.look().made, 2);
  const Vec3& end = all.back()[all.back().size() - 2];
  props_.push_back(ui::labelProp(QStringLiteral("%1°").arg(*degrees, 0, 'f', 1), end,
                                 ui::labelLook(host_.look(), host_.look().made, host_.pixelRatio())));
}

void PullMarks::drag(const LiveEdit& live, const Vec3& from, const Vec3& to) {
  const Color& made = host_.look().made;
  lines(changedNet(live.gridBefore(), live.grid(), netEvery), made, 1);
  lines({{from, to}}, made, 1.5);
  props_.push_back(ui::pointsProp({to}, made, pointPixels * host_.pixelRatio()));
}

std::vector<Vec3> copiesOf(const Motion& motion, const MotionPlace& at, const EditSymmetry& symmetry) {
  std::vector<Vec3> points;
  if (symmetry == EditSymmetry{}) return points;
  const std::vector<SymmetricPlace> places = symmetricPlaces(motion, at, symmetry);
  for (std::size_t k = 1; k < places.size(); ++k) points.push_back(placeHit(motion, places[k].at).point);
  return points;
}

}  // namespace blossom::sweep
