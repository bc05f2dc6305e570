#pragma once
#include "kernel/outline/outline_edit.h"
#include "manipulators/drag_tool.h"

namespace blossom::modeling {

/// Edits a drawn outline: drags its points, adds a point on a segment by a double click, removes one with Delete. Each is
/// one step of undo.
class EditTool final : public DragTool {
  Q_OBJECT
 public:
  EditTool(ui::ToolHost&, FeatureId);

  bool move(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::optional<Vec3> drawsIn() const override { return Vec3::UnitZ(); }

 protected:
  [[nodiscard]] std::vector<Point> points(const Value& parameters) const override;
  [[nodiscard]] std::vector<Dimension> dimensions(const Value& parameters) const override;
  [[nodiscard]] std::optional<Value> resized(const Value& parameters, std::size_t dimension, double to) const override;
  [[nodiscard]] std::string expressionFor(std::size_t dimension) const override;
  [[nodiscard]] Value written(Value kept, const Value& next, std::size_t dimension, const Value& typed) const override;
  [[nodiscard]] std::optional<Value> dragged(const Value& parameters, std::size_t index, const Vec2& to) const override;
  void paint(ToolPaint&, const Value& parameters) const override;
  [[nodiscard]] QString idleHint() const override;

 private:
  void leave();
  [[nodiscard]] std::optional<OutlinePlace> placeUnder(const ui::ToolEvent&) const;
  [[nodiscard]] Value withOutline(const Value& parameters, const DrawnOutline&) const;

  std::optional<OutlinePlace> place_;  ///< on a segment, under the mouse
  bool refused_ = false;               ///< the last Delete would have left nothing
};

}  // namespace blossom::modeling
