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
  [[nodiscard]] std::vector<Dimension> dimensions(const Value& parameters) const override;
  [[nodiscard]] std::optional<Value> resized(const Value& parameters, std::size_t dimension, double to) const override;
  [[nodiscard]] std::optional<Value> dragged(const Value& parameters, std::size_t index, const Vec2& to) const override;

 private:
  /// "the width", for the status line and the undo list.
  [[nodiscard]] static QString nameOf(const std::string& parameter);

  std::string type_;
};

}  // namespace blossom::modeling
