#pragma once
#include <QPointer>
#include <optional>

#include "ui/plugin/tool.h"
#include "ui/tools/section_plane.h"

namespace blossom::ui {

class SectionPanel;

/// A plane that cuts the model open: dragged by its handle or its frame, or set by a small panel or keys. The section
/// remains when the tool has ended; starting the tool again edits it.
class SectionTool : public Tool {
  Q_OBJECT
 public:
  /// @param view the panel floats over it; may be null
  SectionTool(ToolHost& host, QWidget* view);
  ~SectionTool() override;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] PickMode picks() const override { return pickingFace_ ? PickMode::Face : PickMode::None; }
  bool press(const ToolEvent&) override;
  bool move(const ToolEvent&) override;
  bool release(const ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;

  [[nodiscard]] const SectionPlane& plane() const { return plane_; }

 private:
  struct Frame {
    Vec3 centre, tip;  // of the handle
    std::array<Vec3, 4> corners;
  };
  [[nodiscard]] Frame frame() const;
  [[nodiscard]] bool isOnHandle(const ToolEvent&) const;
  void drag(const ToolEvent&);
  void choose(SectionAxis);
  void moveTo(double offset);
  void apply();
  void turnOff();

  SectionPlane plane_;
  Bounds extent_;
  QPointer<SectionPanel> panel_;
  bool pickingFace_ = false, hovered_ = false, dragging_ = false;
  Vec3 taken_ = Vec3::Zero();  // where the handle or the frame was taken
  double grabbed_ = 0;         // from the plane to there, along the direction
  QPointF lastAt_;
};

}  // namespace blossom::ui
