#pragma once
#include <memory>
#include <optional>

#include "kernel/live_pull.h"
#include "manipulators/insert_deform.h"
#include "manipulators/pull_grips.h"
#include "ui/jobs/background.h"
#include "ui/jobs/mailbox.h"
#include "ui/tool.h"

namespace blossom::subdivision {

/// Limit points of a cage's vertices that can be dragged while the cage, or its smooth surface, is selected. While one is
/// dragged, feet and factor are held and the surface within reach follows at once; letting go makes the pull part of a
/// deformation, one step of undo. What takes longer than a frame, the limit surface of a large cage, is made in the
/// background.
class PullTool : public ui::Tool {
  Q_OBJECT
 public:
  PullTool(ui::ToolHost&, FeatureId);
  ~PullTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  /// A drag asks nothing of the scene.
  [[nodiscard]] ui::PickMode picks() const override { return held_ ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void revert() override;

 private:
  using Loaded = std::pair<std::shared_ptr<const GripSurface>, std::vector<Grip>>;

  void load();
  [[nodiscard]] static Loaded loaded(std::shared_ptr<const GripSurface>, const Shape& base, Scheme, const std::vector<Pull>&,
                                     const std::vector<Vec3>& now, const Progress&);
  void take(Loaded);
  [[nodiscard]] std::vector<Vec3> pointsNow() const;
  [[nodiscard]] std::optional<std::size_t> under(const ui::ToolEvent&) const;
  [[nodiscard]] Vec3 dragged(const ui::ToolEvent&) const;
  void begin(std::size_t grip, const ui::ToolEvent&);
  void makeLive(std::vector<LivePull::Handle>);
  void end();
  void commit();

  FeatureId feature_;
  std::optional<DeformPlace> place_;
  Shape base_;
  Scheme scheme_ = Scheme::CatmullClark;
  std::vector<Pull> pulls_;
  DeformOptions options_;
  std::shared_ptr<const GripSurface> surface_;
  std::vector<Grip> grips_;
  std::optional<std::size_t> hovered_, held_;
  std::unique_ptr<LivePull> live_;
  std::vector<std::pair<int, int>> liveEdges_;  ///< of the cage, that move
  std::size_t moving_ = 0;                      ///< which handle of `live_`
  Vec3 grabbed_ = Vec3::Zero(), target_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), towards_ = Vec3::UnitZ();
  bool working_ = false;
  bool outdated_ = false;  ///< something was loaded while a grip was held

  CancelToken loading_;  ///< what is under way; cancelled when it is not wanted any more
  ui::Mailbox here_;
  ui::Background thread_;  // ends first
};

}  // namespace blossom::subdivision
