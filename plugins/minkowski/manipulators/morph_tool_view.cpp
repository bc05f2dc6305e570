// What the morph tool says and draws.
#include <vtkProp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/units.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "manipulators/control_colors.h"
#include "manipulators/morph_tool.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double dotPixels = 5, squarePixels = 4;
constexpr int ringCorners = 64;

Vec3 onGround(const Vec2& p) { return {p.x(), p.y(), 0}; }

QString shown(double value) { return QString::number(value, 'g', 6); }

std::vector<Vec3> circleAround(const Vec2& centre, double radius) {
  std::vector<Vec3> line;
  for (int k = 0; k <= ringCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / ringCorners;
    line.push_back(onGround(centre + radius * Vec2(std::cos(angle), std::sin(angle))));
  }
  return line;
}

/// A square that looks away from a centre.
std::vector<std::array<Vec3, 3>> squareAt(const Vec2& at, const Vec2& centre, double half) {
  const Vec2 along = half * (at - centre).normalized(), across(-along.y(), along.x());
  const Vec3 a = onGround(at - along - across), b = onGround(at + along - across), c = onGround(at + along + across),
             d = onGround(at - along + across);
  return {{a, b, c}, {a, c, d}};
}

}  // namespace

QString MorphTool::offsetText(const Vec2& offset) const {
  const LengthUnit unit = host().lengthUnit();
  return QStringLiteral("%1, %2 %3")
      .arg(shown(offset.x() / unit.millimetres), shown(offset.y() / unit.millimetres), QString::fromStdString(unit.name));
}

/// The number that a drag changes, on a card at the handle; as it is typed with a mark at its end.
QString MorphTool::valueText(const Handle& handle) const {
  if (typing_) return entry_.shown();
  const Placement& now = placements_[handle.shape];
  if (handle.grip == Grip::Scale) return QChar(0xD7) + QStringLiteral(" %1").arg(shown(now.scale));
  if (handle.grip == Grip::Turn) return shown(now.turn) + QChar(0xB0);
  return offsetText(now.offset);
}

QString MorphTool::heldHint(const Handle& handle) const {
  const QString& name = controls_[handle.shape].name;
  const Placement& now = placements_[handle.shape];
  switch (handle.grip) {
    case Grip::Scale:
      if (typing_) return tr("Type how many times as large · Enter takes it · Esc leaves it to the mouse");
      return tr("%1 is %2 times as large as drawn · type a number · Ctrl: no steps · Esc takes it back")
          .arg(name, shown(now.scale));
    case Grip::Turn:
      if (typing_) return tr("Type the angle · Enter takes it · Esc leaves it to the mouse");
      return tr("%1 is turned by %2° · type a number · Ctrl: no steps · Esc takes it back").arg(name, shown(now.turn));
    case Grip::Move:
      break;
  }
  if (typing_) return tr("Type x, y · Enter takes it · Esc leaves it to the mouse");
  return tr("%1 is moved by %2 · type x, y · Ctrl: no snapping · Esc takes it back").arg(name, offsetText(now.offset));
}

QString MorphTool::hoverHint(const Handle& handle) const {
  const QString& name = controls_[handle.shape].name;
  const Placement& now = placements_[handle.shape];
  switch (handle.grip) {
    case Grip::Scale:
      return now.scale == 1 ? tr("Drag to scale %1 in the morph").arg(name)
                            : tr("Drag to scale %1 in the morph · double click: as large as drawn").arg(name);
    case Grip::Turn:
      return now.turn == 0 ? tr("Drag to turn %1 in the morph").arg(name)
                           : tr("Drag to turn %1 in the morph · double click: as it was drawn").arg(name);
    case Grip::Move:
      break;
  }
  return now == Placement() ? tr("Drag to move %1 in the morph").arg(name)
                            : tr("Drag to move %1 in the morph · double click puts it back").arg(name);
}

QString MorphTool::hint() const {
  if (!refusal_.isEmpty()) return refusal_;
  if (held()) return heldHint(handleOf(*held()));
  if (hovered()) return hoverHint(handleOf(*hovered()));
  if (legHovered_)
    return legHovered_ == legShown_ ? tr("Click to show the whole ladder again")
                                    : tr("Click to show the shape on this leg of the ladder");
  return tr(
      "Drag the number of a control shape to move it, the square or the dot on its ring to scale or turn it · L: ladder");
}

/// Ghosts that turn from the colour of the controls to that of the result, and the polygons through their centres.
void MorphTool::drawLadder(std::vector<vtkSmartPointer<vtkProp>>& props) const {
  if (!habits_.ladder || !ladder_) return;
  const double pixel = host().pixelRatio(), count = static_cast<double>(controls_.size()) - 1;
  const Look& look = host().look();
  const auto ghost = [&](std::size_t level) {
    const Color color = mixed(look.control, look.made, static_cast<double>(level + 1) / std::max(count, 1.0));
    return mixed(color, look.backgroundBottom, legShown_ ? 0.75 : 0.4);
  };
  for (std::size_t r = 0; r < ladder_->levels.size(); ++r) {
    std::vector<std::vector<Vec3>> lines;
    for (const LadderShape& shape : ladder_->levels[r]) lines.insert(lines.end(), shape.lines.begin(), shape.lines.end());
    props.push_back(ui::linesProp(lines, ghost(r), pixel));
  }
  const auto polygons = ladderOfPoints(centres(), levels_);
  for (std::size_t r = 0; r < std::min(polygons.size(), ladder_->levels.size()); ++r)
    props.push_back(ui::linesProp({polygons[r]}, ghost(r), 0.75 * pixel));
  drawLeg(props);
}

void MorphTool::drawShapes(std::vector<vtkSmartPointer<vtkProp>>& props) const {
  const double pixel = host().pixelRatio();
  const Look& look = host().look();
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const Color& color = hovered() && handleOf(*hovered()).shape == i ? look.made : look.control;
    // The handles may be made before the view has come near.
    const double largest = 2e-4 * bounds(Shape(controls_[i].region)).diagonal();
    const double chord = std::clamp(millimetresPerPixel() / 4 / placements_[i].scale, 1e-6, std::max(largest, 1e-6));
    const Eigen::Matrix<double, 2, 3> affine = affineOf(placements_[i], controls_[i].centre);
    std::vector<std::vector<Vec3>> outlines;
    for (const Path& loop : controls_[i].region.loops) {
      std::vector<Vec3>& line = outlines.emplace_back();
      for (const Vec2& p : flatten(loop, chord)) line.push_back(onGround(affine.leftCols<2>() * p + affine.col(2)));
      line.push_back(line.front());
    }
    props.push_back(ui::linesProp(outlines, color, 1.25 * pixel));
  }
}

void MorphTool::drawRing(std::vector<vtkSmartPointer<vtkProp>>& props, std::size_t shape) const {
  const double pixel = host().pixelRatio(), millimetres = millimetresPerPixel();
  const Look& look = host().look();
  const auto lit = [&](Grip grip) { return hovered() == numberOf(shape, grip); };
  const auto color = [&](Grip grip) -> const Color& { return lit(grip) ? look.made : look.control; };
  const Vec2 centre = centreOf(shape), scale = gripAt(shape, Grip::Scale, millimetres),
             turn = gripAt(shape, Grip::Turn, millimetres);
  props.push_back(ui::linesProp({circleAround(centre, ringRadius(shape, millimetres))}, look.control, pixel));
  props.push_back(ui::trianglesProp(squareAt(scale, centre, (lit(Grip::Scale) ? 1.25 : 1) * squarePixels * millimetres),
                                    color(Grip::Scale), 1));
  props.push_back(ui::pointsProp({onGround(turn)}, color(Grip::Turn), (lit(Grip::Turn) ? 2.4 : 2) * dotPixels * pixel));
  if (!held()) return;
  const Handle handle = handleOf(*held());
  ui::LabelLook card = ui::labelLook(look, look.made, pixel);
  if (handle.grip == Grip::Move) card.shift = QPointF(0, -2 * ui::labelGap - 22);  // the number stands above
  props.push_back(ui::labelProp(valueText(handle), onGround(gripAt(shape, handle.grip, millimetres)), card));
}

std::vector<vtkSmartPointer<vtkProp>> MorphTool::props() const {
  std::vector<vtkSmartPointer<vtkProp>> props;
  const double pixel = host().pixelRatio();
  const Look& look = host().look();
  drawLadder(props);
  drawShapes(props);
  std::vector<Vec3> polygon;
  for (std::size_t i = 0; i < controls_.size(); ++i) polygon.push_back(onGround(centreOf(i)));
  if (polygon.size() > 1) props.push_back(ui::linesProp({polygon}, look.control, pixel));
  for (std::size_t i = 0; i < controls_.size(); ++i) {
    const bool lit = hovered() == numberOf(i, Grip::Move);
    const Color& color = lit ? look.made : look.control;
    props.push_back(ui::pointsProp({polygon[i]}, color, (lit ? 2.4 : 2) * dotPixels * pixel));
    ui::LabelLook card = ui::labelLook(look, lit ? look.made : controlColor(look, i), pixel);
    card.shift = QPointF(badgeShift(i, millimetresPerPixel()), 0);
    props.push_back(ui::labelProp(QString::number(i + 1), polygon[i], card));
  }
  if (ringed_) drawRing(props, *ringed_);
  return props;
}

}  // namespace blossom::minkowski
