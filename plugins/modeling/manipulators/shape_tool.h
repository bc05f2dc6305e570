#pragma once
#include "manipulators/drag_tool.h"

namespace blossom::modeling {

/// Handles of outlines defined by a few sizes: centre, corners, radii.
class ShapeTool final : public DragTool {
  Q_OBJECT
 public:
  ShapeTool(ui::ToolHost&, FeatureId);

 protected:
  [[nodiscard]] std::vector<Point> points(const Value& parameters) const override;
  [[nodiscard]] std::optional<Value> dragged(const Value& parameters, std::size_t index, const Vec2& to) const override;

 private:
  std::string type_;
};

}  // namespace blossom::modeling
