#pragma once
#include <optional>
#include <vector>

#include "geometry/planar/region.h"
#include "parameter/value.h"
#include "ui/tools/handle_tool.h"

namespace blossom::minkowski {

/// The control shapes of a morph at their positions, each with a handle at its centre. A drag sets the parameter `offsets`:
/// the document is previewed meanwhile, and the whole drag is one step of undo.
class MorphTool final : public ui::HandleTool {
  Q_OBJECT
 public:
  MorphTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool doubleClick(const ui::ToolEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  /// A control shape as it was drawn.
  struct Control {
    Region region;
    Vec2 centre = Vec2::Zero();
    QString name;
  };
  void load() override;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override { offsets_ = before_; }
  [[nodiscard]] Vec2 handleOf(std::size_t shape) const { return controls_[shape].centre + offsets_[shape]; }
  [[nodiscard]] Document with(const std::vector<Vec2>& offsets) const;

  Document base_;  ///< the document that a drag starts from
  std::vector<Control> controls_;
  std::vector<Vec2> offsets_;  ///< one for each control shape
  std::vector<Vec2> before_;
  Vec2 grabbed_ = Vec2::Zero();  ///< offset from the handle to the mouse at the start of the drag
};

}  // namespace blossom::minkowski
