#pragma once
#include <optional>
#include <vector>

#include "ui/tools/handle_tool.h"

namespace blossom::morphology {

/// A handle above the middle of a solid that inflates, or below its top when it melts: dragged up and down, it sets the
/// parameter `radius`. The document is previewed meanwhile; letting go is one step of undo.
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
  /// The height over the top where the ray passes nearest to the vertical through it; nothing when it runs along it.
  [[nodiscard]] std::optional<double> heightUnder(const Ray&) const;
  [[nodiscard]] Document with(double radius) const;

  Direction direction_;
  Document base_;            ///< the document that a drag starts from
  std::optional<Vec3> top_;  ///< above the middle of the solid; nothing while the solid is not known
  double radius_ = 1;
  double before_ = 1, grabbed_ = 0;
};

}  // namespace blossom::morphology
