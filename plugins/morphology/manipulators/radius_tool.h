#pragma once
#include <optional>
#include <vector>

#include "ui/tools/handle_tool.h"

namespace blossom::morphology {

/// A handle above the middle of a solid that inflates, or below its top when it melts or is rounded; dragging it up and down
/// sets the parameter `radius`. The document is previewed meanwhile; the whole drag is one step of undo.
class RadiusTool final : public ui::HandleTool {
  Q_OBJECT
 public:
  enum class Direction { Outwards, Inwards };
  RadiusTool(ui::ToolHost&, FeatureId, Direction);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  void load() override;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override { radius_ = before_; }
  [[nodiscard]] double sign() const { return direction_ == Direction::Outwards ? 1 : -1; }
  [[nodiscard]] Vec3 handle() const { return *top_ + sign() * radius_ * Vec3::UnitZ(); }
  /// The height above the top at which the ray passes nearest to the vertical through it; empty when the ray is vertical.
  [[nodiscard]] std::optional<double> heightUnder(const Ray&) const;
  [[nodiscard]] Document with(double radius) const;

  Direction direction_;
  Document base_;            ///< the document that a drag starts from
  std::optional<Vec3> top_;  ///< the point of the top above the middle of the solid; empty while the solid is unknown
  double radius_ = 1;
  double before_ = 1, grabbed_ = 0;
};

}  // namespace blossom::morphology
