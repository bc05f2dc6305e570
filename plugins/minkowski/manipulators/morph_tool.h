#pragma once
#include <optional>
#include <vector>

#include "geometry/region.h"
#include "parameter/value.h"
#include "ui/tool.h"

namespace blossom::minkowski {

/// The control shapes of a morph where they stand, each with a handle at its centre. A drag writes the parameter `offsets`:
/// the document is previewed meanwhile, letting go is one step of undo. Takes only what happens on its handles.
class MorphTool final : public ui::Tool {
  Q_OBJECT
 public:
  MorphTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void revert() override;

 private:
  /// A control shape as it was drawn.
  struct Control {
    Region region;
    Vec2 centre = Vec2::Zero();
    QString name;
  };
  void load();
  [[nodiscard]] Vec2 offsetOf(std::size_t) const;
  [[nodiscard]] Vec2 handleOf(std::size_t shape) const { return controls_[shape].centre + offsetOf(shape); }
  [[nodiscard]] std::optional<std::size_t> under(const ui::ToolEvent&) const;
  [[nodiscard]] Document with(const std::vector<Vec2>& offsets) const;
  void drag(const ui::ToolEvent&);
  void endDrag();
  void commit(const std::vector<Vec2>& offsets, const QString& what);

  FeatureId feature_;
  Document base_;  ///< the document that a drag starts from
  std::vector<Control> controls_;
  std::vector<Vec2> offsets_;  ///< one for each control shape
  std::vector<Vec2> before_;
  Vec2 grabbed_ = Vec2::Zero();  ///< from the handle to where the mouse took it
  std::optional<std::size_t> hovered_, dragged_;
  bool committing_ = false;
  double millimetresPerPixel_ = 1;
};

}  // namespace blossom::minkowski
