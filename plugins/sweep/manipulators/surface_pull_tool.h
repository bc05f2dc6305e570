#pragma once
#include <memory>
#include <optional>

#include "manipulators/held_edit.h"
#include "manipulators/insert_edit.h"
#include "manipulators/lingering_picture.h"
#include "manipulators/marks/pull_grip.h"
#include "manipulators/pull_mode.h"
#include "manipulators/surface_loader.h"
#include "manipulators/typed_goal.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/view_props.h"

namespace blossom::sweep {

class PullMarks;

/// Pulls a swept surface by hand while its sweep, or an edit of its motion, is selected: any place of the surface is a
/// handle. During a drag a shaded grid of the surface stands in for it and follows at once; the end of the drag, or Enter
/// after the goal was typed, adds a pull or a twist before the sweep, or changes the last one when a place of it was taken,
/// as one step of undo. So is an earlier one changed that is selected: during the drag the surface is shown as that edit
/// leaves it. Finding places is prepared in the background. Of a motion that nothing sweeps there is no surface to
/// take hold of, which the hint says.
class SurfacePullTool : public ui::HandleTool {
  Q_OBJECT
 public:
  SurfacePullTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  void mouseGone() override;
  bool key(const QKeyEvent&) override;
  bool wheel(double notches, Qt::KeyboardModifiers) override;
  void keysLost() override;
  [[nodiscard]] std::optional<Vec3> whereabouts() const override;
  [[nodiscard]] bool entering() const override { return entry_.has_value(); }
  /// No picking during a drag.
  [[nodiscard]] ui::PickMode picks() const override { return held() ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  [[nodiscard]] std::optional<ui::StandIn> standIn() const override;

 private:
  /// What `handleUnder` finds.
  enum Handle : std::size_t { anyPlace, placeOfEdit, axisOfEdit };

  void load() override;
  void show(std::shared_ptr<const LiveSurface>);
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override;

  [[nodiscard]] bool comesEarly(const ui::ToolEvent&) const;
  void takeEarlyPress();
  void look(const ui::ToolEvent&);
  void lookAgain();
  /// What is under the mouse on the surface that a drag there changes; empty while that is not ready.
  [[nodiscard]] std::optional<PullGrip> gripToHold() const;
  /// That of the selected edit, and while places are twisted.
  [[nodiscard]] bool showsAxis(const ChangeableEdit& edit) const { return mode_.twists() || edit.id == feature(); }
  /// Whether it is a place of an edit that others follow.
  [[nodiscard]] bool isFollowed(const PullGrip& grip) const { return grip.of && edits_[grip.of->edit].isFollowed; }
  void hold(const PullGrip&, const DragTarget&, double pixel);
  void follow();
  void commitEdit(const std::optional<TypedGoal>&);

  // Keys.
  bool chooseKey(int key);
  bool keyOfMode(const QKeyEvent&);
  bool keyWhilePreparing(const QKeyEvent&);
  bool typingKey(const QKeyEvent&);
  void startTyping();
  void followTyped(bool ready = false);
  void takeTyped();
  void stopTyping();

  // What is said and drawn.
  [[nodiscard]] QString idleHint() const;
  /// How the selected edit goes, whatever is chosen for the next one; empty when none is selected.
  [[nodiscard]] QString selectedText() const;
  /// Nothing is seen of a surface whose sweeps fail.
  [[nodiscard]] bool isShown() const;
  [[nodiscard]] QString typingHint() const;
  [[nodiscard]] QString typingProblem() const;
  [[nodiscard]] QString heldHint() const;
  [[nodiscard]] QString hoverHint() const;
  [[nodiscard]] QString keysHint(bool single, bool ownLevel) const;
  [[nodiscard]] QString chosenHint() const;
  [[nodiscard]] QString heldText() const;
  [[nodiscard]] QString leftText() const;
  [[nodiscard]] QString wayText() const;
  [[nodiscard]] std::vector<ui::PropPtr> marksOfResult() const;
  void markPlace(PullMarks&) const;
  void markEdit(PullMarks&) const;
  void markAxes(PullMarks&) const;
  void markTurnedAxis(PullMarks&, const Vec3& centre, const Vec3& axis) const;

  PullMode& mode_;  ///< stays in force when something else is selected meanwhile
  std::optional<EditPlacement> placement_;
  bool unseen_ = false;  ///< no sweep takes the motion
  std::vector<ChangeableEdit> edits_;
  std::shared_ptr<const LiveSurface> surface_;
  std::shared_ptr<const LiveSurface> selectedSurface_;  ///< of a selected edit that others follow
  ChosenPlaces chosen_;
  std::optional<PullGrip> under_;   ///< what is under the mouse
  bool overSurface_ = false;        ///< the mouse was, when it was last looked for
  Vec3 towards_ = Vec3::UnitY();    ///< line of sight
  std::unique_ptr<HeldEdit> edit_;  ///< that is being made
  std::optional<GoalEntry> entry_;  ///< its goal is being typed
  QString refusal_;                 ///< why it cannot be what is typed
  std::optional<LingeringPicture> lingering_;
  std::optional<ui::ToolEvent> mouse_;  ///< what it did last
  std::optional<ui::ToolEvent> early_;  ///< a press on the surface that is being prepared; the button is still down
  QPointF pressedAt_, letGoAt_;
  double notches_ = 0;  ///< of the wheel, that make no whole one yet
  bool dragged_ = false;

  SurfaceLoader loader_{[this](std::shared_ptr<const LiveSurface> surface) { show(std::move(surface)); }};
  SurfaceLoader selectedLoader_{
      [this](std::shared_ptr<const LiveSurface> surface) { selectedSurface_ = std::move(surface); }};
};

}  // namespace blossom::sweep
