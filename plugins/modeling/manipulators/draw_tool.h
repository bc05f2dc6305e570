#pragma once
#include <vector>

#include "kernel/outline/outline_draft.h"
#include "manipulators/tool_scene.h"
#include "ui/plugin/tool.h"

namespace blossom::modeling {

class ToolPaint;

/// Draws a new outline by clicks; OutlineDraft defines their meaning.
class DrawTool : public ui::Tool {
  Q_OBJECT
 public:
  explicit DrawTool(ui::ToolHost&);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] QString undoText() const override;
  [[nodiscard]] QString redoText() const override;
  void undo() override;
  void redo() override;
  [[nodiscard]] std::optional<Vec3> drawsIn() const override { return Vec3::UnitZ(); }
  [[nodiscard]] ui::PickMode picks() const override { return ui::PickMode::None; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void conclude() override;

 private:
  void hover(const ui::ToolEvent&);
  void place();
  void finish();
  FeatureId commitDrawn();
  void refuse(const QString& why);
  bool entryKey(const QKeyEvent&);
  bool commandKey(const QKeyEvent&);
  bool historyKey(const QKeyEvent&);
  void takeBack();
  [[nodiscard]] QString wanted() const;
  void paintRubber(ToolPaint&) const;
  void paintDrawn(ToolPaint&) const;

  OutlineDraft draft_;
  std::vector<OutlineDraft> undone_;  ///< as it was before each point that was taken back, the last one at the end
  SnapScene scene_;
  double millimetresPerPixel_ = 1;
  QString refusal_;  ///< why the last click had no effect; until the next move
};

}  // namespace blossom::modeling
