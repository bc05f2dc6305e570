#include "manipulators/morph_tool.h"

#include <vtkProp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "control_shapes.h"
#include "core/error.h"
#include "feature/registry.h"
#include "geometry/shape/sequence.h"
#include "kernel/morph/control_centre.h"
#include "manipulators/morph_card.h"
#include "manipulators/placement_values.h"
#include "parameter/written.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double gripPixels = 9, snapPixels = 6, samePlacePixels = 2;
constexpr double scaleStep = 0.1, turnStep = 15, smallestScale = 0.01;
constexpr double badgeHalfWidth = 12, badgeHeight = 22;  // logical pixels, of a number on its card

double degreesOf(const Vec2& direction) { return std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi; }

/// The same angle in (-180, 180].
double shortestTurn(double degrees) {
  const double turn = std::remainder(degrees, 360);
  return turn <= -180 ? turn + 360 : turn + 0.0;  // -0 would be written as such
}

/// To a power of ten below what a pixel is worth: more digits would be nothing that a hand has set.
double roundedToPixels(double value, double millimetresPerPixel) {
  const double finest = std::pow(10, std::floor(std::log10(millimetresPerPixel)));
  return finest < 1 ? std::round(value / finest) / std::round(1 / finest) : std::round(value / finest) * finest;
}

/// The nearest line of the grid where one is in reach; the place where the shape was drawn is on all of them.
double snappedTo(double value, double spacing, double millimetresPerPixel) {
  const double line = std::round(value / spacing) * spacing;
  if (std::abs(line - value) <= snapPixels * millimetresPerPixel) return line;
  return roundedToPixels(value, millimetresPerPixel);
}

}  // namespace

MorphTool::MorphTool(ui::ToolHost& toolHost, FeatureId feature)
    : HandleTool(toolHost, std::move(feature)),
      habits_(toolHost.kept<MorphHabits>()),
      loader_([this](std::shared_ptr<const LadderLines> lines) {
        ladder_ = std::move(lines);
        forgetLostLeg();
        refreshCard();
        emit changed();
      }) {
  load();
  makeCard();
  refreshCard();
}

MorphTool::~MorphTool() { delete card_; }

/// While a path is drawn the document is the preview of it, which may have frames that the path asks for: the next preview
/// is made of what was there before.
void MorphTool::load() {
  if (!drawingPath_) base_ = host().document();
  const Feature& morph = base_.at(feature());
  const auto type = host().registry().at(morph.type);
  controls_.clear();
  moving_ = false;
  for (const FeatureId& input : morph.inputs) {
    const auto result = host().result(input);
    if (!result || result->error) break;  // handles come when all shapes before them are known
    moving_ = moving_ || result->evaluated.shape.get<Sequence>();
    try {
      const std::vector<Shape> twice(2, shapeSeen(result->evaluated.shape));  // read as the feature reads it
      const Region region = controlShapesOf(arrangedInputs(*type, twice)).front();
      controls_.push_back({region, minkowski::centreOf(region), QString::fromStdString(base_.at(input).name)});
    } catch (const Error&) {
      break;  // the feature itself says what is wrong with it
    }
  }
  placements_ = placementsIn(completed(type->parameters, morph.parameters), controls_.size());
  const auto isGone = [this](std::optional<std::size_t> shape) { return shape && *shape >= controls_.size(); };
  if (hovered() && handleOf(*hovered()).shape >= controls_.size()) forgetHovered();
  if (isGone(chosen_)) chosen_.reset();
  if (isGone(ringed_)) ringed_.reset();
}

Document MorphTool::with(const std::vector<Placement>& placements) const {
  Feature morph = base_.at(feature());
  const std::vector<ParameterSpec>& specs = host().registry().at(morph.type)->parameters;
  Value parameters = completed(specs, morph.parameters);
  writePlacements(parameters, placements);
  morph.parameters = keepWritten(specs, morph.parameters, parameters);
  return base_.with(std::move(morph));
}

std::size_t MorphTool::numberOf(std::size_t shape, Grip grip) { return gripCount * shape + static_cast<std::size_t>(grip); }

MorphTool::Handle MorphTool::handleOf(std::size_t number) {
  return {number / gripCount, static_cast<Grip>(number % gripCount)};
}

/// While a shape is scaled, the ring grows with it: the square stays under the mouse.
double MorphTool::ringRadius(std::size_t shape, double millimetresPerPixel) const {
  const bool scaling = held() == numberOf(shape, Grip::Scale);
  return ringPixels * millimetresPerPixel * (scaling ? placements_[shape].scale / before_[shape].scale : 1);
}

Vec2 MorphTool::gripAt(std::size_t shape, Grip grip, double millimetresPerPixel) const {
  if (grip == Grip::Move) return centreOf(shape);
  const double turn = (placements_[shape].turn + (grip == Grip::Turn ? 90 : 0)) * std::numbers::pi / 180;
  return centreOf(shape) + ringRadius(shape, millimetresPerPixel) * Vec2(std::cos(turn), std::sin(turn));
}

/// The control shape whose centre is nearest; of several at one place the one that was clicked last.
std::optional<std::size_t> MorphTool::nearest(const ui::ToolEvent& event, double pixels) const {
  const auto at = ui::inGround(event.ray);
  if (!at) return std::nullopt;
  std::optional<std::size_t> best;
  double reach = pixels * event.millimetresPerPixel;
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const double distance = (centreOf(i) - *at).norm();
    if (distance > reach) continue;
    reach = distance;
    best = i;
  }
  const auto together = [&](std::size_t a, std::size_t b) {
    return (centreOf(a) - centreOf(b)).norm() <= samePlacePixels * event.millimetresPerPixel;
  };
  return best && chosen_ && together(*best, *chosen_) ? chosen_ : best;
}

/// Numbers of shapes at one place stand side by side. @returns logical pixels to the right
double MorphTool::badgeShift(std::size_t shape, double millimetresPerPixel) const {
  double shift = 0;
  for (std::size_t i = 0; i < shape; ++i)
    if ((centreOf(i) - centreOf(shape)).norm() < badgeHalfWidth * millimetresPerPixel) shift += 2 * badgeHalfWidth + 2;
  return shift;
}

/// The number above a dot has a place in the picture, not in the plane. The one drawn last lies in front.
std::optional<std::size_t> MorphTool::badgeUnder(const ui::ToolEvent& event) const {
  for (std::size_t i = controls_.size(); i-- > 0;) {
    const auto seen = host().onScreen({centreOf(i).x(), centreOf(i).y(), 0});
    if (!seen) continue;
    const double right = event.at.x() - seen->x() - badgeShift(i, event.millimetresPerPixel),
                 up = seen->y() - event.at.y() - ui::labelGap;
    if (std::abs(right) <= badgeHalfWidth && up >= 0 && up <= badgeHeight) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> MorphTool::shapeNear(const ui::ToolEvent& event) const {
  return nearest(event, ringPixels + gripPixels);
}

/// What can always be taken comes before what the ring of a neighbour lays over it.
std::optional<std::size_t> MorphTool::handleUnder(const ui::ToolEvent& event) const {
  if (const auto dot = nearest(event, gripPixels)) return numberOf(*dot, Grip::Move);
  if (const auto badge = badgeUnder(event)) return numberOf(*badge, Grip::Move);
  const auto at = ui::inGround(event.ray);
  if (!at) return std::nullopt;
  for (const auto& shape : {shapeNear(event), chosen_})
    for (const Grip grip : {Grip::Scale, Grip::Turn})
      if (shape && (gripAt(*shape, grip, event.millimetresPerPixel) - *at).norm() <= gripPixels * event.millimetresPerPixel)
        return numberOf(*shape, grip);
  return std::nullopt;
}

void MorphTool::showRingOf(std::optional<std::size_t> shape) {
  const bool same = shape == ringed_ && (!shape || ringScale_ == millimetresPerPixel());
  ringed_ = shape;
  ringScale_ = millimetresPerPixel();
  if (!same) emit changed();
}

bool MorphTool::press(const ui::ToolEvent& event) {
  const bool taken = HandleTool::press(event);
  if (event.button != Qt::LeftButton) return taken;
  if (const auto leg = taken ? std::nullopt : legUnder(event)) {
    legPressed_ = true;
    legShown_ = legShown_ == leg ? std::nullopt : leg;
    refreshCard();
    emit changed();
    return true;
  }
  chosen_ = held() ? std::optional(handleOf(*held()).shape) : std::nullopt;
  showRingOf(chosen_);
  return taken;
}

/// A click on a leg is no click on the shape behind it.
bool MorphTool::release(const ui::ToolEvent& event) {
  if (event.button == Qt::LeftButton && std::exchange(legPressed_, false)) return true;
  return HandleTool::release(event);
}

bool MorphTool::move(const ui::ToolEvent& event) {
  const bool taken = HandleTool::move(event);
  if (held()) return taken;
  const auto near = hovered() ? std::optional(handleOf(*hovered()).shape) : shapeNear(event);
  showRingOf(near ? near : chosen_);
  const auto leg = hovered() ? std::nullopt : legUnder(event);
  if (leg != legHovered_) emit changed();
  legHovered_ = leg;
  return taken || leg.has_value();
}

bool MorphTool::take(std::size_t handle, const ui::ToolEvent& event) {
  load();
  const auto at = ui::inGround(event.ray);
  const std::size_t shape = handleOf(handle).shape;
  if (!at || shape >= controls_.size()) return false;
  before_ = placements_;
  grabbed_ = *at - centreOf(shape);
  mouse_.reset();
  typing_ = false;
  refusal_.clear();
  return true;
}

Placement MorphTool::dragged(const Handle& handle, const ui::ToolEvent& event, const Vec2& at) const {
  const bool free = event.modifiers.testFlag(Qt::ControlModifier);
  Placement to = before_[handle.shape];
  const Vec2 arm = at - controls_[handle.shape].centre - to.offset;  // of scaling and turning
  switch (handle.grip) {
    case Grip::Move: {
      to.offset = at - grabbed_ - controls_[handle.shape].centre;
      const auto snapped = [&](double value) { return snappedTo(value, host().gridSpacing(), event.millimetresPerPixel); };
      if (!free) to.offset = {snapped(to.offset.x()), snapped(to.offset.y())};
      break;
    }
    case Grip::Scale: {
      const double scale = to.scale * arm.norm() / grabbed_.norm();
      to.scale = free ? std::max(scale, smallestScale) : std::max(1.0, std::round(scale / scaleStep)) / (1 / scaleStep);
      break;
    }
    case Grip::Turn: {
      const double turn = to.turn + degreesOf(arm) - degreesOf(grabbed_);
      to.turn = shortestTurn(free ? turn : std::round(turn / turnStep) * turnStep);
      break;
    }
  }
  return to;
}

void MorphTool::drag(const ui::ToolEvent& event) {
  mouse_ = event;
  const auto at = ui::inGround(event.ray);
  if (at && !typing_) follow(dragged(handleOf(*held()), event, *at));
}

void MorphTool::follow(const Placement& to) {
  Placement& now = placements_[handleOf(*held()).shape];
  if (now == to) return;
  now = to;
  preview(with(placements_), [this](const Document& exact) { return coarser(exact); });
}

void MorphTool::place() {
  if (placements_ == before_) return;
  const auto [shape, grip] = handleOf(*held());
  const QString& name = controls_[shape].name;
  commit(with(placements_), grip == Grip::Move    ? tr("Move %1 in the morph").arg(name)
                            : grip == Grip::Scale ? tr("Scale %1 in the morph").arg(name)
                                                  : tr("Turn %1 in the morph").arg(name));
}

void MorphTool::putBack() {
  placements_ = before_;
  typing_ = false;
  refusal_.clear();
}

/// On the number everything goes back, on the square and the dot of the ring what they change.
bool MorphTool::doubleClick(const ui::ToolEvent& event) {
  const auto found = handleUnder(event);
  if (!found) return false;
  load();
  const auto [shape, grip] = handleOf(*found);
  if (shape >= controls_.size()) return true;
  std::vector<Placement> placements = placements_;
  if (grip == Grip::Move) placements[shape] = {};
  if (grip == Grip::Scale) placements[shape].scale = 1;
  if (grip == Grip::Turn) placements[shape].turn = 0;
  if (placements != placements_) commit(with(placements), tr("Put %1 back as it was drawn").arg(controls_[shape].name));
  return true;
}

}  // namespace blossom::minkowski
