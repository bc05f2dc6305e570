#include "manipulators/shape_tool.h"

#include "manipulators/shape_handles.h"

namespace blossom::modeling {

ShapeTool::ShapeTool(ui::ToolHost& toolHost, FeatureId feature)
    : DragTool(toolHost, std::move(feature)), type_(host().document().at(this->feature()).type) {}

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

std::optional<Value> ShapeTool::dragged(const Value& parameters, std::size_t index, const Vec2& to) const {
  return draggedHandle(type_, parameters, index, to);
}

}  // namespace blossom::modeling
