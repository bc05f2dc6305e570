#pragma once
#include <QImage>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/plugin/tool.h"
#include "ui/view/camera_control.h"
#include "ui/view/live_picture.h"
#include "ui/view/view_navigation.h"
#include "ui/view/view_stage.h"

namespace blossom::ui {

class CurvatureLegend;
class MouseNavigation;
class ViewCube;

/// The canvas: the stage as a live picture, the camera that the mouse moves, and what the mouse finds and selects. Geometry
/// is sent to the graphics card once; orbiting only moves the camera.
class ViewWidget : public QWidget, private PictureSubject {
  Q_OBJECT
 public:
  explicit ViewWidget(QWidget* parent = nullptr);
  ~ViewWidget() override;

  /// Where the view takes its contents from once they are said to be out of date: before its next picture, or before
  /// something is looked up in it. So they are made once for a picture, however often something changes.
  struct Source {
    std::function<std::vector<ViewItem>()> items;
    std::function<std::vector<vtkSmartPointer<vtkProp>>()> overlay;
    /// Points that what moves by itself comes to, which the view has to have room for; none: nothing moves.
    std::function<std::vector<Vec3>()> reach = {};
  };
  void setSource(Source source) { source_ = std::move(source); }
  void markItems();    ///< they are out of date
  void markOverlay();  ///< likewise
  void setItems(const std::vector<ViewItem>&);
  void setOverlay(std::vector<vtkSmartPointer<vtkProp>>);
  /// Gets mouse and keys first until another is set; nullptr: none. Not owned. `handles` are there beside what the view does
  /// itself: what they leave alone lights up and is selected as if they were not there.
  void setTool(Tool* tool, bool handles = false);
  [[nodiscard]] Tool* tool() const { return tool_; }
  /// What the tool drags goes back, as by Esc: the mouse button may be let go where the view does not hear of it.
  void takeDragBack();
  /// Gives the tool a key that the widget with the focus did not want. Whether it took it.
  bool takeKeyFromElsewhere(const QKeyEvent&);
  void setLook(const Look&);
  void setGridVisible(bool);
  [[nodiscard]] bool gridVisible() const;
  void setParallel(bool);
  [[nodiscard]] bool parallel() const { return camera_.parallel(); }
  void setDisplayMode(DisplayMode);
  [[nodiscard]] DisplayMode displayMode() const { return stage_.items().displayMode(); }
  void setZebra(const ZebraLook&);
  void setNavigation(NavigationStyle);
  [[nodiscard]] NavigationStyle navigation() const;
  /// Cuts all shapes; closed ones look filled where they are cut. What is cut away is not picked.
  void setSection(const std::optional<CutPlane>&);
  [[nodiscard]] const std::optional<CutPlane>& section() const { return stage_.section(); }

  /// What lights up under the mouse and is selected by a click. Forgets the parts selected before.
  void setPickMode(PickMode);
  [[nodiscard]] PickMode pickMode() const { return pickMode_; }
  /// Faces, edges and points that are selected; in Feature mode there are none, features are selected by who listens.
  void setSelectedParts(const std::vector<Pick>&);
  [[nodiscard]] const std::vector<Pick>& selectedParts();
  /// Parts that a form marks, whatever is selected.
  void setMarkedParts(const MarkedParts&);
  [[nodiscard]] const MarkedParts& markedParts() const { return stage_.marked(); }
  /// What is under a point of the view, logical pixels.
  [[nodiscard]] Pick pickAt(QPointF, PickMode);
  /// What lies in a rectangle: wholly, or in part when `crossing`.
  [[nodiscard]] std::vector<Pick> picksIn(const QRectF&, PickMode, bool crossing);
  [[nodiscard]] const Pick& hoveredPick() const { return hovered_; }

  void fit(bool animated = true);
  void fitTo(const std::vector<Vec3>& points, bool animated = true) { camera_.frame(points, camera_.heading(), animated); }
  void lookFrom(const QString& view, bool animated = true);  ///< a name of viewNames(); frames everything
  void zoomBy(double factor);
  [[nodiscard]] const CameraControl& camera() const { return camera_; }
  [[nodiscard]] CameraControl& camera() { return camera_; }
  [[nodiscard]] Bounds extent();                                             ///< of all that is shown
  [[nodiscard]] double gridSpacing() const { return stage_.gridSpacing(); }  ///< mm
  [[nodiscard]] double lastFrameMs() const { return picture_->lastFrameMs(); }
  [[nodiscard]] int framesDrawn() const { return picture_->framesDrawn(); }
  /// Every pixel is drawn, not every second one as while something moves slowly, and nothing is out of date.
  [[nodiscard]] bool detailed() const { return picture_->detailed(); }
  /// All edges are smoothed, too; at first, and while the camera moves, that is left out where it would stutter.
  [[nodiscard]] bool sharp() const { return picture_->sharp(); }

  /// Why nothing can be drawn; empty when all is well.
  [[nodiscard]] QString problem() const { return picture_->problem(); }
  /// What is shown, drawn before when it is out of date.
  QImage grabFramebuffer() { return picture_->upToDate(); }

  /// What the mouse would do on the view now, with the tool that is started.
  [[nodiscard]] QString restingHint() const;
  /// What the mouse would do when it rests on the view.
  static QString idleHint(NavigationStyle style = NavigationStyle::Blossom) { return navigationHint(style); }

 signals:
  void picked(const QString& feature, bool extend);  ///< a click, or a box for each feature in it; empty: the canvas itself
  void partPicked(const blossom::ui::Pick&, Qt::KeyboardModifiers);  ///< any click, in every mode; no feature: the canvas
  void hovered(const blossom::ui::Pick&);                            ///< changed
  void framePainted();                                               ///< a new picture is on the screen
  void partsSelected();                                              ///< selectedParts() changed
  void selectionBoxed(const std::vector<blossom::ui::Pick>&, Qt::KeyboardModifiers);
  void contextMenuWanted(const QPoint& globalPosition, const blossom::ui::Pick&);
  void toolDismissed();  ///< Esc, which the tool did not want
  void hint(const QString& text);
  /// The point that the tool tells, or that of the ground under the cursor with the grid.
  void whereabouts(const QString& text);
  void filesDropped(const QStringList& files);

 protected:
  void paintEvent(QPaintEvent*) override;
  bool event(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void leaveEvent(QEvent*) override;
  void focusOutEvent(QFocusEvent*) override;

 private:
  enum class KeyOffer { None, Refused, Taken };

  void connectParts();
  // PictureSubject
  [[nodiscard]] vtkRenderer& renderer() override { return stage_.renderer(); }
  [[nodiscard]] bool stale() const override { return itemsStale_ || overlayStale_; }
  void bringUpToDate() override;
  [[nodiscard]] bool incomplete() const override { return stage_.items().incomplete(); }
  void bringNextPiece() override { stage_.bringNextPiece(); }
  [[nodiscard]] bool empty() const override { return stage_.items().empty(); }
  [[nodiscard]] bool canBeCoarser() const override { return stage_.items().canBeCoarser(); }
  void prepareFrame(QPointF offset, QSize picture, bool coarse, double share) override;

  void paintProblem(const QPaintEvent&);
  [[nodiscard]] std::vector<Vec3> everything();
  void placeCube();
  void followCurvature();
  // What the mouse does.
  [[nodiscard]] ToolEvent toolEvent(QPointF at, Qt::MouseButton, Qt::KeyboardModifiers);
  void markTool();
  void bringToolUpToDate();
  bool offerKey(const QKeyEvent&);
  void leaveDrag();
  [[nodiscard]] bool secondButton(const QMouseEvent*) const;
  bool offerTab(const QKeyEvent&);
  void takeKeys();
  void hoverAt(QPointF at, Qt::KeyboardModifiers);
  void hoverAgain();
  void setHovered(const Pick&);
  void startDrag(QPointF at, Qt::MouseButtons, Qt::KeyboardModifiers);
  void click(QPointF at, Qt::KeyboardModifiers);
  void selectParts(const std::vector<Pick>&, Qt::KeyboardModifiers);
  void finishBox(QPointF at, Qt::KeyboardModifiers);
  void tellWhereabouts(QPointF);

  ViewStage stage_;
  Source source_;
  bool itemsStale_ = false, overlayStale_ = false;
  CameraControl camera_;
  std::unique_ptr<LivePicture> picture_;
  Turn frameTurn_;  // how the camera stands in the newest frame
  ViewCube* cube_;
  CurvatureLegend* legend_;
  MouseNavigation* navigation_;

  QPointer<Tool> tool_;
  bool handles_ = false, toolHasMouse_ = false;
  bool toolStale_ = false;            ///< what it draws
  std::optional<QPointF> mouseAt_;    ///< over the view, with no button down
  std::optional<QPointF> pressedAt_;  ///< where the tool took a press; empty after a double click, which is done
  KeyOffer keyOffer_ = KeyOffer::None;
  PickMode pickMode_ = PickMode::Feature;
  Pick hovered_;
};

}  // namespace blossom::ui
