#include "manipulators/edit_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <cmath>

#include "core/error.h"
#include "document/named_numbers.h"
#include "features_outline_value.h"
#include "kernel/outline/outline_sides.h"
#include "manipulators/side_writing.h"
#include "manipulators/tool_paint.h"
#include "manipulators/tool_scene.h"
#include "ui/tools/view_props.h"

namespace blossom::modeling {

EditTool::EditTool(ui::ToolHost& toolHost, FeatureId feature) : DragTool(toolHost, std::move(feature)) {}

Value EditTool::withOutline(const Value& parameters, const DrawnOutline& outline) const {
  Value next = parameters;
  next.update(parametersOf(outline));
  return completed(host().registry().at(host().document().at(feature()).type)->parameters, next);
}

std::vector<DragTool::Point> EditTool::points(const Value& parameters) const {
  const DrawnOutline outline = drawnOutlineOf(parameters);
  std::vector<Point> points;
  for (const OutlineHandle& handle : handlesOf(outline)) {
    const bool first = handle.segment < 0;
    points.push_back({handle.at, first ? tr("the first point") : tr("a point of the outline"), pointBefore(outline, handle),
                      handle.through >= 0});
  }
  return points;
}

std::vector<DragTool::Dimension> EditTool::dimensions(const Value& parameters) const {
  std::vector<Dimension> all;
  for (const StraightSide& side : straightSides(drawnOutlineOf(parameters)))
    all.push_back(
        {(side.from + side.to) / 2, side.outward, (side.to - side.from).norm(), tr("the length of this side"), {}});
  return all;
}

std::optional<Value> EditTool::resized(const Value& parameters, std::size_t dimension, double to) const {
  const DrawnOutline outline = drawnOutlineOf(parameters);
  const auto next = withSideLength(outline, straightSides(outline).at(dimension).segment, to);
  return next ? std::optional(withOutline(parameters, *next)) : std::nullopt;
}

std::string EditTool::expressionFor(std::size_t dimension) const {
  const DrawnOutline outline = drawnOutlineOf(parameters());
  return writtenLength(host().document().at(feature()).parameters, outline, straightSides(outline).at(dimension));
}

Value EditTool::written(Value kept, const Value& next, std::size_t dimension, const Value& typed) const {
  const Document& document = host().document();
  const DrawnOutline before = drawnOutlineOf(parameters()), after = drawnOutlineOf(next);
  const StraightSide side = straightSides(before).at(dimension);
  std::string expression = typed.is_string() ? typed.get<std::string>() : std::string();
  if (isNamedExpression(typed)) expression = typed.at("expression").get<std::string>();
  if (!axisOf(side)) {
    if (isNamedExpression(typed))
      throw Error(
          ErrorCode::InvalidParameter,
          tr("This side is slanted, and only level and upright sides keep an expression with names: type its value, or "
             "write expressions for its points under \"segments\".")
              .toStdString());
    expression.clear();
  }
  // Which points go with the side shows in another length of it, also when this one stays but for rounding.
  const double length = (side.to - side.from).norm();
  const auto longer = withSideLength(before, side.segment, 1.001 * length);
  const bool stays =
      std::abs(checked(specOf(dimensions(parameters()).at(dimension)), typed).get<double>() - length) < 1e-6 * length;
  const DrawnOutline& moved = stays && longer ? *longer : after;
  return withExpressions(std::move(kept), document.at(feature()).parameters, {before, after, moved, side, expression},
                         namedNumbersOf(document));
}

std::optional<Value> EditTool::dragged(const Value& parameters, std::size_t index, const Vec2& to) const {
  const DrawnOutline outline = drawnOutlineOf(parameters);
  const DrawnOutline next = moved(outline, handlesOf(outline).at(index), to);
  try {
    (void)toPath(next);
  } catch (const Error&) {
    return std::nullopt;  // two points on each other: stays where it was last
  }
  return withOutline(parameters, next);
}

std::optional<OutlinePlace> EditTool::placeUnder(const ui::ToolEvent& event) const {
  const auto at = ui::inGround(event.ray);
  if (!at || handleUnder(event)) return std::nullopt;
  auto place = nearestPlace(drawnOutlineOf(parameters()), *at);
  if (!place || place->distance > gripPixels * event.millimetresPerPixel) return std::nullopt;
  return place;
}

bool EditTool::move(const ui::ToolEvent& event) {
  const bool had = place_.has_value();
  refused_ = false;
  place_ = held() ? std::nullopt : placeUnder(event);
  const bool taken = DragTool::move(event);
  if (had || place_) emit changed();
  return taken || (place_ && event.button == Qt::NoButton);
}

bool EditTool::doubleClick(const ui::ToolEvent& event) {
  if (DragTool::doubleClick(event)) return true;
  const auto place = placeUnder(event);
  if (event.button != Qt::LeftButton || !place) return false;
  place_.reset();
  commit(withOutline(parameters(), withPointAt(drawnOutlineOf(parameters()), *place)), tr("Insert a point"));
  return true;
}

bool EditTool::key(const QKeyEvent& event) {
  if (DragTool::key(event)) return true;
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Escape) {
    leave();
    return true;
  }
  const bool removes = event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
  const auto index = chosen() ? chosen() : hovered();
  if (!removes || held() || !index) return false;
  const DrawnOutline outline = drawnOutlineOf(parameters());
  const auto next = without(outline, handlesOf(outline).at(*index));
  refused_ = !next;
  if (next) commit(withOutline(parameters(), *next), tr("Remove a point"));
  emit changed();
  return true;
}

// What stays selected would be given handles again.
void EditTool::leave() {
  ui::ToolHost& workbench = host();
  revert();
  emit finished();
  workbench.select({});
}

QString EditTool::idleHint() const {
  if (refused_) return tr("Too little would be left of the outline; delete the feature itself instead.");
  if (place_) return tr("Double-click to insert a point here");
  return tr("Drag points · double-click a segment to insert one · Delete removes the chosen one · Enter or Esc leaves");
}

void EditTool::paint(ToolPaint& paint, const Value& parameters) const {
  try {
    paint.path(toPath(drawnOutlineOf(parameters)), paint.look().control, 1.5);
  } catch (const Error&) {
    return;  // the feature itself says what is wrong; its points can still be dragged
  }
  if (place_) paint.square(place_->at, paint.look().made, false, 3);
}

}  // namespace blossom::modeling
