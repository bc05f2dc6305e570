#include "manipulators/marks/pull_marks.h"

#include <vtkProp.h>

#include <algorithm>
#include <cmath>

#include "kernel/edit/motion_symmetry.h"
#include "manipulators/marks/axis_ball.h"

namespace blossom::sweep {

namespace {

constexpr double twistRadius = 40;  // of the arc of a point on the axis
constexpr double pointPixels = 10, copyPixels = 9, copyHolePixels = 5, pinPixels = 7, ballPixels = 13;
constexpr double seamPixels = 1.3;
constexpr QPointF halfLabel(26, 11);  // logical pixels, of a card with an angle
constexpr double cardHeight = 26;     // with the gap to the one above it
constexpr double labelDistance = 16;  // from the end of an arc to the card

}  // namespace

void PullMarks::lines(const std::vector<std::vector<Vec3>>& all, const Color& color, double width) {
  if (all.empty()) return;
  // Drivers draw lines of one device pixel whatever width they are asked for: where these are fine, a hair.
  const double ratio = host_.pixelRatio();
  props_.push_back(ratio > 1 ? ui::linesProp(thickened(all, facing_, width, ratio), color, 1)
                             : ui::linesProp(all, color, width));
}

void PullMarks::seamed(const std::vector<std::vector<Vec3>>& all, const Color& color, double width) {
  lines(all, color, width);
  lines(besides(all, facing_, seamPixels), host_.look().backgroundBottom, width);
}

void PullMarks::points(const std::vector<Vec3>& all, const Color& color, double pixels) {
  if (!all.empty()) props_.push_back(ui::pointsProp(all, color, pixels * host_.pixelRatio()));
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
  SurfaceLines border;
  for (const EditRegion& region : editRegions(motion, hit.at, mode)) {
    const SurfaceLines each = borderOf(motion, region, towards, side);
    border.facing.insert(border.facing.end(), each.facing.begin(), each.facing.end());
    border.averted.insert(border.averted.end(), each.averted.begin(), each.averted.end());
  }
  surfaceLines(border, 1);
  isoCurves(motion, hit, towards);
  points({hit.point}, host_.look().control, pointPixels);
}

void PullMarks::isoCurves(const Motion& motion, const PlaceHit& hit, const Vec3& towards) {
  const double side = hit.normal.dot(towards) >= 0 ? 1 : -1;
  surfaceLines(isoCurvesThrough(motion, hit.at, towards, side), 1.8);
}

/// Hollow, unlike places that were chosen. Of points at one place the first is seen.
void PullMarks::copies(const std::vector<Vec3>& all) {
  points(all, host_.look().backgroundBottom, copyHolePixels);
  points(all, host_.look().control, copyPixels);
}

void PullMarks::chosen(const std::vector<Vec3>& moved, const std::vector<Vec3>& pinned) {
  points(moved, host_.look().control, pointPixels);
  std::vector<std::vector<Vec3>> squares;
  squares.reserve(pinned.size());
  for (const Vec3& at : pinned) squares.push_back(squareOnScreen(at, facing_, pinPixels));
  seamed(squares, host_.look().control, 2);
  points(pinned, host_.look().control, pinPixels / 2);
}

void PullMarks::ring(const Vec3& centre, const PullMode& mode) {
  props_.push_back(ui::pictureProp(ringPicture(mode.weights(), host_.look(), host_.pixelRatio()), centre));
}

void PullMarks::axis(const Vec3& centre, const Vec3& axis) {
  const Vec3 half = axisPixels * facing_.pixel * axis;
  seamed({{centre - half, centre + half}}, host_.look().control, 2);
}

void PullMarks::ball(const Vec3& at, bool active) {
  points({at}, active ? host_.look().made : host_.look().control, ballPixels);
}

void PullMarks::turn(const TwistArc& arc, const QString& text) {
  const std::vector<Vec3> line = arcOf(arc, twistRadius * facing_.pixel);
  seamed({line}, host_.look().made, 2);
  if (text.isEmpty()) return;
  // Beyond the end of the arc, where neither the arc nor the point that is dragged lies.
  const Vec3 &foot = line.front(), &end = line[line.size() - 2];
  const Vec2 out((end - foot).dot(facing_.right), (end - foot).dot(facing_.up));
  const Vec2 away = out.norm() > 0 ? Vec2(out.normalized()) : Vec2(0, 1);
  ui::LabelLook look = ui::labelLook(host_.look(), host_.look().made, host_.pixelRatio());
  look.card = ui::qtColor(host_.look().backgroundBottom);
  look.shift = {away.x() * (labelDistance + halfLabel.x()),
                away.y() * (labelDistance + halfLabel.y()) - halfLabel.y() - ui::labelGap};
  props_.push_back(ui::labelProp(text, end, look));
}

void PullMarks::way(const Vec3& from, const Vec3& to) {
  seamed({{from, to}}, host_.look().control, 1.5);
  points({to}, host_.look().control, pointPixels);
}

void PullMarks::tell(const Vec3& at, const QString& text, bool aboveRing) {
  ui::LabelLook look = ui::labelLook(host_.look(), host_.look().control, host_.pixelRatio());
  look.card = ui::qtColor(host_.look().backgroundBottom);
  if (aboveRing) look.shift = {0, ringReach};
  props_.push_back(ui::labelProp(text, at, look));
}

void PullMarks::problem(const Vec3& at, const QString& text, bool aboveCard) {
  ui::LabelLook look = ui::labelLook(host_.look(), host_.look().fault, host_.pixelRatio());
  look.card = ui::qtColor(host_.look().backgroundBottom);
  look.shift = {0, aboveCard ? ringReach + cardHeight : ringReach};
  look.follow = true;
  props_.push_back(ui::labelProp(text, at, look));
}

void PullMarks::entry(const Vec3& at, const ui::TypedText& text, const QString& unit, const QString& wrong) {
  const Color &made = host_.look().made, &ground = host_.look().backgroundBottom;
  if (!wrong.isEmpty()) problem(at, wrong, true);
  ui::LabelLook look = ui::labelLook(host_.look(), text.selected() ? ground : made, host_.pixelRatio());
  look.card = ui::qtColor(text.selected() ? made : ground);
  look.border = ui::qtColor(made);
  look.shift = {0, ringReach};  // above the ring
  look.follow = true;           // wherever the point goes
  props_.push_back(ui::labelProp(text.shown() + unit, at, look));
}

std::vector<Vec3> copiesOf(const Motion& motion, const MotionPlace& at, const EditSymmetry& symmetry) {
  std::vector<Vec3> points;
  if (symmetry == EditSymmetry{}) return points;
  const std::vector<SymmetricPlace> places = symmetricPlaces(motion, at, symmetry);
  for (std::size_t k = 1; k < places.size(); ++k) points.push_back(placeHit(motion, places[k].at).point);
  return points;
}

}  // namespace blossom::sweep
