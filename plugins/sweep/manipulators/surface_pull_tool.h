#pragma once
#include <memory>
#include <optional>

#include "manipulators/drag_target.h"
#include "manipulators/insert_edit.h"
#include "manipulators/live_edit.h"
#include "manipulators/pull_mode.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"
#include "ui/tools/handle_tool.h"

namespace blossom::sweep {

class PullMarks;

/// Pulls a swept surface by hand while its sweep, or an edit of its motion, is selected: any place of the surface is a
/// handle. During a drag a grid of the surface follows at once; the end of the drag adds a pull or a twist before the sweep,
/// or changes the last one when its place was taken, as one step of undo. Finding places is prepared in the background.
class SurfacePullTool : public ui::HandleTool {
  Q_OBJECT
 public:
  SurfacePullTool(ui::ToolHost&, FeatureId);
  ~SurfacePullTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  /// No picking during a drag.
  [[nodiscard]] ui::PickMode picks() const override { return held() ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  /// What `handleUnder` finds.
  enum Handle : std::size_t { anyPlace, placeOfLast };

  void load() override;
  void show(std::shared_ptr<const LiveSurface>);
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override;

  void look(const ui::ToolEvent&);
  [[nodiscard]] std::optional<PlaceHit> lastUnder(const ui::ToolEvent&) const;
  [[nodiscard]] std::optional<PlaceHit> anyUnder(const ui::ToolEvent&) const;
  [[nodiscard]] bool changesLast() const;
  [[nodiscard]] const Motion& base() const;
  [[nodiscard]] MotionEdit currentEdit() const;
  [[nodiscard]] MotionTwist currentTwist() const;
  [[nodiscard]] MotionPull currentPull() const;
  [[nodiscard]] double angle() const;
  void follow();
  [[nodiscard]] QString heldHint() const;
  [[nodiscard]] QString hoverHint() const;
  void markPlace(PullMarks&) const;
  void markDrag(PullMarks&) const;

  PullMode mode_;
  std::optional<EditPlacement> placement_;
  std::optional<LastEdit> last_;
  Shape wanted_;  ///< the motion whose surface is shown, or being prepared
  std::shared_ptr<const LiveSurface> surface_;
  std::optional<PlaceHit> under_;  ///< the place under the mouse; during a drag the one taken hold of
  bool onLast_ = false;            ///< it is that of the last edit
  Vec3 towards_ = Vec3::UnitY();   ///< line of sight

  DragTarget target_;
  std::optional<Motion> lastBase_;  ///< before the last edit, when its place was taken
  std::unique_ptr<LiveEdit> live_;
  QPointF pressedAt_;
  bool dragged_ = false;

  CancelToken loading_;  ///< cancels work in the background that is no longer needed
  ui::Mailbox here_;
  ui::Background thread_;  // ends first
};

}  // namespace blossom::sweep
