#pragma once
#include <QPointer>
#include <memory>
#include <optional>

#include "manipulators/factors/factor_live.h"
#include "manipulators/factors/factor_net.h"
#include "manipulators/factors/factor_place.h"
#include "manipulators/factors/pole_drag.h"
#include "manipulators/lingering_picture.h"
#include "manipulators/surface_loader.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/view_props.h"

namespace blossom::sweep {

class FactorsPanel;

/// Edits the factors of a motion pole by pole: the trajectory by handles in space, orientation and scaling by a net over the
/// (u, v) domain on a card over the view (Yoon & Lee 2009, section 3). During a drag a grid of the surface follows at once;
/// its end, a typed number or a knot changes the document between the motion and its sweeps, as one step of undo.
class FactorsTool final : public ui::HandleTool {
  Q_OBJECT
 public:
  /// @param feature a sweep, an edit of its motion or a motion; empty: what is selected. @throws Error as featureOfFactors.
  FactorsTool(ui::ToolHost&, const FeatureId& feature);
  ~FactorsTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  [[nodiscard]] ui::PickMode picks() const override { return held() ? ui::PickMode::None : ui::PickMode::Feature; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;
  [[nodiscard]] std::optional<ui::StandIn> standIn() const override;
  void revert() override;

 private:
  using Props = std::vector<ui::PropPtr>;

  // The document and its motion.
  void load() override;
  void show(std::shared_ptr<const LiveSurface>);
  void enter(const FactorChanges&, const QString& what, int field);
  void insertKnot(bool alongU, double knot);
  [[nodiscard]] bool editable() const;
  void tellEditable();
  [[nodiscard]] const Motion& motion() const { return live_ ? live_->motion() : surface_->motion(); }

  // Handles on the trajectory: its poles, then the axes of the one that is chosen.
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override;
  [[nodiscard]] std::vector<Vec3> poles() const;
  [[nodiscard]] std::optional<Vec3> axesAt() const;  ///< where the axes are drawn
  [[nodiscard]] double axisLength() const;

  // The card.
  void makePanel();
  void connectPanel(FactorsPanel&);
  void close();
  void chooseFactor(Factor);
  void fillPanel();
  void fillPlot();
  [[nodiscard]] QString summary() const;
  [[nodiscard]] static QString undoTextOf(const FactorChanges&);
  void dragNet(const QPointF& pixels);
  void dragBall(const Vec3& turn);
  void dragPanel(const FactorChanges&, const QString& what);
  void dropPanel();
  void cancelPanel();
  void type(int field, const QString& text);
  void turn(bool absolute);
  [[nodiscard]] std::optional<double> typedNumber(int field, const QString& text);
  [[nodiscard]] std::optional<Vec3> typedAxis();
  void startLive();
  void follow(const FactorChanges&);
  void commitDrag(const QString& what);
  void look();
  [[nodiscard]] bool draws(bool (FactorsPanel::*shown)() const) const;

  // What is drawn.
  void drawTrajectory(Props&) const;
  void drawPlaces(Props&) const;
  void drawMotion();

  Factor factor_ = Factor::Scaling;
  FactorNet::Chosen chosen_;
  QPointer<FactorsPanel> panel_;
  QString said_;  ///< by the card, for the status line
  std::optional<EditPlacement> placement_;
  std::shared_ptr<const LiveSurface> surface_;
  Vec3 towards_ = Vec3(-1, 1, -1).normalized();  ///< line of sight

  std::unique_ptr<FactorLive> live_;
  std::optional<LingeringPicture> lingering_;
  bool onPanel_ = false;  ///< the drag is one on the card
  PoleDrag pole_;
  QPointF pressedAt_;
  bool dragged_ = false;
  Props motionProps_;  ///< frames and iso-curves of the motion at rest

  SurfaceLoader loader_{[this](std::shared_ptr<const LiveSurface> surface) { show(std::move(surface)); }};
};

}  // namespace blossom::sweep
