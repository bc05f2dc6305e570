#pragma once
#include <optional>

#include "kernel/deform.h"
#include "manipulators/curve_cage.h"
#include "manipulators/insert_deform.h"
#include "ui/tools/handle_tool.h"

namespace blossom::subdivision {

/// Points of a limit curve that can be dragged while the smooth curve of a control polygon is selected. During a drag the
/// curve is shown as the deformation will make it; the end of the drag adds the pull to that deformation as one step of
/// undo. A drawing is dragged within its plane, a curve in space in the plane that faces the viewer.
class CurveTool : public ui::HandleTool {
  Q_OBJECT
 public:
  CurveTool(ui::ToolHost&, FeatureId);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] ui::PickMode picks() const override { return held() ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

 private:
  struct Grip {
    Vec3 base = Vec3::Zero();         ///< on the limit curve of the cage as it was
    Vec3 now = Vec3::Zero();          ///< current position
    std::optional<std::size_t> pull;  ///< index of its pull
  };

  void load() override;
  void readDeform();
  void findGrips();
  [[nodiscard]] std::vector<Vec3> pointsNow() const;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t grip, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override { follows_.clear(); }
  [[nodiscard]] Vec3 dragged(const ui::ToolEvent&) const;
  [[nodiscard]] std::vector<Vec3> lineOf(const std::vector<Vec3>& points) const;

  std::optional<DeformPlace> place_;
  CurveCage cage_;
  SchemeChoice scheme_ = SchemeChoice::CatmullClark;
  bool flat_ = false;
  std::vector<Row> line_;  ///< of points along the curve, near enough to each other to draw it
  std::vector<Pull> pulls_;
  DeformOptions options_;
  std::vector<Grip> grips_;
  std::vector<Pull> moving_;   ///< the pulls with the one that is dragged
  std::size_t which_ = 0;      ///< of `moving_`
  std::vector<Vec3> follows_;  ///< the curve as it would become, and the polygon
  std::vector<Vec3> polygon_;
  Vec3 grabbed_ = Vec3::Zero(), target_ = Vec3::Zero(), towards_ = Vec3::UnitZ();
};

}  // namespace blossom::subdivision
