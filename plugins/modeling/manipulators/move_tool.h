#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ui/tools/handle_tool.h"

namespace blossom::modeling {

/// Three arrows and a point in the middle of a transformed shape, which change the parameter `move`: along an axis each, and
/// parallel to the ground. What is made of the shape follows; the whole drag is one step of undo.
class MoveTool final : public ui::HandleTool {
  Q_OBJECT
 public:
  MoveTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  static constexpr std::size_t middleHandle = 3;  ///< after those of the axes

  void load() override;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override { move_ = before_; }
  [[nodiscard]] Vec3 middle() const { return *middleBefore_ + move_ - before_; }
  [[nodiscard]] double arrowLength() const;
  /// The place on the line of an axis, or in the plane, nearest to a ray; nothing where that is seen from its end.
  [[nodiscard]] std::optional<Vec3> placeUnder(std::size_t handle, const Vec3& through, const Ray&) const;
  [[nodiscard]] Document with(const Vec3& move) const;
  [[nodiscard]] QString told() const;

  Document base_;                                ///< the document that a drag starts from
  std::shared_ptr<const FeatureResult> result_;  ///< whose middle is known
  std::optional<Vec3> middleBefore_;             ///< of the shape before the drag; empty while it is unknown
  Vec3 move_ = Vec3::Zero(), before_ = Vec3::Zero();
  Vec3 grabbed_ = Vec3::Zero();  ///< the place that was taken
};

}  // namespace blossom::modeling
