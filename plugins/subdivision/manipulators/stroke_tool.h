#pragma once
#include <optional>

#include "manipulators/insert_deform.h"
#include "ui/plugin/tool.h"

namespace blossom::subdivision {

/// Draws a target stroke over a shape: clicks place points, dragging draws freehand. The stroke lies in a plane through its
/// first point, which X, Y and Z turn. When a cage or its smooth surface is selected, the stroke becomes the target of its
/// deformation.
class StrokeTool : public ui::Tool {
  Q_OBJECT
 public:
  explicit StrokeTool(ui::ToolHost&);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] ui::PickMode picks() const override { return ui::PickMode::Any; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  [[nodiscard]] Vec3 normal(const ui::ToolEvent&) const;
  [[nodiscard]] std::optional<Vec3> placeOf(const ui::ToolEvent&) const;
  void add(const Vec3&);
  void finish();

  FeatureId shape_;  ///< the shape to deform; empty: none
  std::optional<DeformPlace> place_;
  std::vector<Vec3> points_;
  std::optional<Vec3> hovered_;
  bool flat_ = false;        ///< the shape lies in the drawing plane, and so do strokes unless a key sets another plane
  std::optional<int> axis_;  ///< chosen by a key; else the axis closest to the viewing direction
  Vec3 normal_ = Vec3::UnitY();
  double pixel_ = 1;
  bool drawing_ = false;
};

}  // namespace blossom::subdivision
