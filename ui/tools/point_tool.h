#pragma once
#include "ui/tools/pick_tool.h"
#include "ui/tools/place_snap.h"

namespace blossom::ui {

/// Answers the request of a form for a place in space: the mouse snaps to points of what is shown and to the grid, and says
/// so. Ctrl: no snapping.
class PointTool final : public PickTool {
  Q_OBJECT
 public:
  PointTool(ToolHost&, PickRequest);

  [[nodiscard]] QString hint() const override;
  bool move(const ToolEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;

 protected:
  [[nodiscard]] std::optional<Pick> answerAt(const ToolEvent&) const override;

 private:
  [[nodiscard]] std::optional<SnapPlace> placeAt(const ToolEvent&) const;

  std::vector<SnapPlace> places_;
  std::optional<SnapPlace> hovered_;
};

}  // namespace blossom::ui
