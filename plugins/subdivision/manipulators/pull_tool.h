#pragma once
#include <memory>
#include <optional>

#include "kernel/live_pull.h"
#include "manipulators/insert_deform.h"
#include "manipulators/pull_grips.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"
#include "ui/tools/handle_tool.h"

namespace blossom::subdivision {

/// Limit points of a cage's vertices that can be dragged while the cage, or its smooth surface, is selected. During a drag,
/// feet and factorisation are kept and the influenced surface follows at once; the end of the drag adds the pull to a
/// deformation as one step of undo. What takes longer than a frame, such as the limit surface of a large cage, is computed
/// in the background.
class PullTool : public ui::HandleTool {
  Q_OBJECT
 public:
  PullTool(ui::ToolHost&, FeatureId);
  ~PullTool() override;

  [[nodiscard]] QString hint() const override;
  /// No picking during a drag.
  [[nodiscard]] ui::PickMode picks() const override { return held() ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  using Loaded = std::pair<std::shared_ptr<const GripSurface>, std::vector<Grip>>;

  void load() override;
  [[nodiscard]] static Loaded loaded(std::shared_ptr<const GripSurface>, const Shape& base, Scheme, const std::vector<Pull>&,
                                     const std::vector<Vec3>& now, const Progress&);
  void show(Loaded);
  [[nodiscard]] std::vector<Vec3> pointsNow() const;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t grip, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override { live_.reset(); }
  [[nodiscard]] Vec3 dragged(const ui::ToolEvent&) const;
  void makeLive(std::vector<LivePull::Handle>);
  void findLiveEdges();

  std::optional<DeformPlace> place_;
  Shape base_;
  Scheme scheme_ = Scheme::CatmullClark;
  std::vector<Pull> pulls_;
  DeformOptions options_;
  std::shared_ptr<const GripSurface> surface_;
  std::vector<Grip> grips_;
  std::unique_ptr<LivePull> live_;
  std::vector<std::pair<int, int>> liveEdges_;  ///< edges of the cage that move
  std::size_t moving_ = 0;                      ///< index of the handle in `live_`
  Vec3 grabbed_ = Vec3::Zero(), target_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), towards_ = Vec3::UnitZ();

  CancelToken loading_;  ///< cancels work in the background that is no longer needed
  ui::Mailbox here_;
  ui::Background thread_;  // ends first
};

}  // namespace blossom::subdivision
