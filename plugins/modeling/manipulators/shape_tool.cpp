#include "manipulators/shape_tool.h"

#include <map>

#include "manipulators/shape_handles.h"

namespace blossom::modeling {

ShapeTool::ShapeTool(ui::ToolHost& toolHost, FeatureId feature)
    : DragTool(toolHost, std::move(feature)), type_(host().document().at(this->feature()).type) {}

QString ShapeTool::nameOf(const std::string& parameter) {
  const std::map<std::string, QString> names{{"width", tr("the width")},        {"height", tr("the height")},
                                             {"length", tr("the length")},      {"radius", tr("the radius")},
                                             {"outer", tr("the outer radius")}, {"inner", tr("the inner radius")},
                                             {"a", tr("the first half-axis")},  {"b", tr("the second half-axis")}};
  const auto found = names.find(parameter);
  return found == names.end() ? tr("the size") : found->second;
}

std::vector<DragTool::Point> ShapeTool::points(const Value& parameters) const {
  const auto name = [](HandleRole role) {
    switch (role) {
      case HandleRole::Centre:
        return tr("the shape");
      case HandleRole::Corner:
        return tr("the corner");
      case HandleRole::Rounding:
        return tr("the rounding");
      case HandleRole::Size:
        break;
    }
    return tr("the size");
  };
  std::vector<Point> points;
  const auto handles = shapeHandles(type_, parameters);
  for (const auto& handle : handles) {
    const bool centre = handle.role == HandleRole::Centre;
    points.push_back({handle.at, name(handle.role), centre ? std::nullopt : std::optional(handles.front().at),
                      centre || handle.role == HandleRole::Rounding});
  }
  return points;
}

std::vector<DragTool::Dimension> ShapeTool::dimensions(const Value& parameters) const {
  std::vector<Dimension> all;
  for (const ShapeDimension& each : shapeDimensions(type_, parameters))
    all.push_back({each.at, each.beside, parameters.at(each.parameter).get<double>(), nameOf(each.parameter), each.parameter,
                   each.radius});
  return all;
}

std::optional<Value> ShapeTool::resized(const Value& parameters, std::size_t dimension, double to) const {
  Value next = parameters;
  next[shapeDimensions(type_, parameters).at(dimension).parameter] = to;
  return next;
}

std::optional<Value> ShapeTool::dragged(const Value& parameters, std::size_t index, const Vec2& to) const {
  return draggedHandle(type_, parameters, index, to);
}

}  // namespace blossom::modeling
