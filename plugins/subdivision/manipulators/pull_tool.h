#pragma once
#include <memory>
#include <optional>

#include "kernel/limit_surface.h"
#include "kernel/live_pull.h"
#include "manipulators/insert_deform.h"
#include "ui/tool.h"

namespace blossom::subdivision {

/// Limit points of a cage's vertices that can be dragged while the cage, or its smooth surface, is selected. While one is
/// dragged, feet and factor are held and the surface within reach follows at once; letting go makes the pull part of a
/// deformation, one step of undo.
class PullTool : public ui::Tool {
  Q_OBJECT
 public:
  PullTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  void documentChanged() override;
  void revert() override;

 private:
  /// A place that can be taken hold of: the limit point of a vertex, or of a pull that there is.
  struct Grip {
    Vec3 base = Vec3::Zero();  ///< on the limit surface of the base
    Vec3 now = Vec3::Zero();   ///< where it has been pulled to
    Foot foot;
    std::optional<std::size_t> pull;  ///< its number
  };

  void load();
  void loadGrips();
  [[nodiscard]] std::optional<std::size_t> under(const ui::ToolEvent&) const;
  [[nodiscard]] Vec3 dragged(const ui::ToolEvent&) const;
  void begin(std::size_t grip, const ui::ToolEvent&);
  void end();
  void commit();

  FeatureId feature_;
  std::optional<DeformPlace> place_;
  Shape base_;  ///< keeps the mesh alive
  std::vector<Pull> pulls_;
  DeformOptions options_;
  std::unique_ptr<LimitSurface> surface_;  ///< made when something is first taken hold of
  std::vector<Grip> grips_;
  std::optional<std::size_t> hovered_, held_;
  std::unique_ptr<LivePull> live_;
  std::size_t moving_ = 0;  ///< which handle of `live_`
  Vec3 grabbed_ = Vec3::Zero(), target_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), towards_ = Vec3::UnitZ();
  bool working_ = false;
};

}  // namespace blossom::subdivision
