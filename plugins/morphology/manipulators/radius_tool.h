#pragma once
#include <optional>
#include <vector>

#include "ui/tool.h"

namespace blossom::morphology {

/// A handle above the middle of a solid that inflates, or below its top when it melts: dragged up and down, it sets the
/// parameter `radius`. The document is previewed meanwhile; letting go is one step of undo. Takes only what happens on it.
class RadiusTool final : public ui::Tool {
  Q_OBJECT
 public:
  enum class Direction { Outwards, Inwards };
  RadiusTool(ui::ToolHost&, FeatureId, Direction);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void revert() override;

 private:
  void load();
  [[nodiscard]] double sign() const { return direction_ == Direction::Outwards ? 1 : -1; }
  [[nodiscard]] Vec3 handle() const { return *top_ + sign() * radius_ * Vec3::UnitZ(); }
  [[nodiscard]] bool isUnder(const ui::ToolEvent&) const;
  /// The height over the top where the ray passes nearest to the vertical through it; nothing when it runs along it.
  [[nodiscard]] std::optional<double> heightUnder(const Ray&) const;
  [[nodiscard]] Document with(double radius) const;
  void drag(const ui::ToolEvent&);
  void endDrag();

  FeatureId feature_;
  Direction direction_;
  Document base_;            ///< the document that a drag starts from
  std::optional<Vec3> top_;  ///< above the middle of the solid; nothing while the solid is not known
  double radius_ = 1;
  double before_ = 1, grabbed_ = 0;
  bool hovered_ = false, dragging_ = false, committing_ = false;
};

}  // namespace blossom::morphology
