#pragma once
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/plugin/tool.h"
#include "ui/view/camera_control.h"
#include "ui/view/ground_grid.h"
#include "ui/view/smoothing.h"
#include "ui/view/view_highlight.h"
#include "ui/view/view_items.h"
#include "ui/view/view_navigation.h"

class vtkProp;
class vtkRenderer;

namespace blossom::ui {

class Painter;
class SelectionBand;
class ViewCube;

/// The canvas, drawn by VTK. Geometry is sent to the graphics card once; orbiting only moves the camera, and nothing is
/// drawn while nothing changes. While a frame is drawn the window goes on: the picture follows when it is there.
class ViewWidget : public QWidget {
  Q_OBJECT
 public:
  explicit ViewWidget(QWidget* parent = nullptr);
  ~ViewWidget() override;

  /// Where the view takes its contents from once they are said to be out of date: before its next picture, or before
  /// something is looked up in it. So they are made once for a picture, however often something changes.
  struct Source {
    std::function<std::vector<ViewItem>()> items;
    std::function<std::vector<vtkSmartPointer<vtkProp>>()> overlay;
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
  void setLook(const Look&);
  void setGridVisible(bool);
  [[nodiscard]] bool gridVisible() const;
  void setParallel(bool);
  [[nodiscard]] bool parallel() const { return camera_.parallel(); }
  void setDisplayMode(DisplayMode);
  [[nodiscard]] DisplayMode displayMode() const { return items_.displayMode(); }
  void setNavigation(NavigationStyle);
  [[nodiscard]] NavigationStyle navigation() const { return navigation_; }
  /// Cuts all shapes; closed ones look filled where they are cut. What is cut away is not picked.
  void setSection(const std::optional<CutPlane>&);
  [[nodiscard]] const std::optional<CutPlane>& section() const { return section_; }

  /// What lights up under the mouse and is selected by a click. Forgets the parts selected before.
  void setPickMode(PickMode);
  [[nodiscard]] PickMode pickMode() const { return pickMode_; }
  /// Faces, edges and points that are selected; in Feature mode there are none, features are selected by who listens.
  void setSelectedParts(const std::vector<Pick>&);
  [[nodiscard]] const std::vector<Pick>& selectedParts();
  /// What is under a point of the view, logical pixels.
  [[nodiscard]] Pick pickAt(QPointF, PickMode);
  /// What lies in a rectangle: wholly, or in part when `crossing`.
  [[nodiscard]] std::vector<Pick> picksIn(const QRectF&, PickMode, bool crossing);
  [[nodiscard]] const Pick& hoveredPick() const { return hovered_; }

  void fit(bool animated = true);
  void fitTo(const std::vector<Vec3>& points, bool animated = true) { camera_.frame(points, camera_.turn(), animated); }
  void lookFrom(const QString& view, bool animated = true);  ///< a name of viewNames(); frames everything
  void zoomBy(double factor);
  [[nodiscard]] const CameraControl& camera() const { return camera_; }
  [[nodiscard]] CameraControl& camera() { return camera_; }
  [[nodiscard]] Bounds extent();                                        ///< of all that is shown
  [[nodiscard]] double gridSpacing() const { return grid_.spacing(); }  ///< mm
  [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
  [[nodiscard]] int framesDrawn() const { return framesDrawn_; }
  /// All edges are smoothed; at first, and while the camera moves, that is left out where it would stutter.
  [[nodiscard]] bool sharp() const { return !frame_ && !stale() && smooth(); }

  [[nodiscard]] QString problem() const;  ///< why nothing can be drawn; empty when all is well
  /// What is shown, drawn before when it is out of date.
  QImage grabFramebuffer();

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
  void whereabouts(const QString& text);  ///< cursor on the ground and grid
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

 private:
  enum class KeyOffer { None, Refused, Taken };

  void buildRenderer();
  void applyLook();
  [[nodiscard]] bool stale() const { return itemsStale_ || overlayStale_; }
  void bringUpToDate();
  // Frames: begun here, drawn beside what the window does, shown when they are there.
  [[nodiscard]] bool smooth() const { return smoothing_.complete() || (multisampled_ && smoothing_.taken() > 0); }
  void sizePicture();
  void wantFrame() { next_.start(); }
  void beginFrame();
  void comeToRest();
  void lookForFrame();
  void takeFrame();
  void showFrame(const std::vector<std::uint32_t>& pixels);
  void drawNow();
  void prepareFrame();
  void paintProblem(const QPaintEvent&);
  void keepGridLast();
  void keepGridInSight();
  [[nodiscard]] Look scaledLook() const;
  [[nodiscard]] std::vector<Vec3> everything();
  void placeCube();
  void redrawMoving();
  void redraw();  // soon and fast; smoothed when things have come to rest
  void chooseSmoothing();
  // What the mouse does.
  [[nodiscard]] QString restingHint() const;
  [[nodiscard]] PickOptions pickOptions() const;
  [[nodiscard]] ToolEvent toolEvent(QPointF at, Qt::MouseButton, Qt::KeyboardModifiers);
  void showToolProps();
  bool offerKey(const QKeyEvent&);
  void hoverAt(QPointF at, Qt::KeyboardModifiers);
  void setHovered(const Pick&);
  void startDrag(QPointF at, Qt::MouseButtons, Qt::KeyboardModifiers);
  void drag(QPointF at);
  void click(QPointF at, Qt::KeyboardModifiers);
  void selectParts(const std::vector<Pick>&, Qt::KeyboardModifiers);
  void finishBox(QPointF at, Qt::KeyboardModifiers);
  void tellWhereabouts(QPointF);

  std::shared_ptr<Painter> painter_;
  QImage picture_;
  vtkSmartPointer<vtkRenderer> renderer_;
  Source source_;
  bool itemsStale_ = false, overlayStale_ = false;
  ViewItems items_;
  PartHighlight hoverLight_, selected_;
  std::vector<vtkSmartPointer<vtkProp>> overlay_, toolProps_;
  GroundGrid grid_;
  Look look_ = Look::dark();
  CameraControl camera_;
  ViewCube* cube_;
  SelectionBand* band_;

  QPointer<Tool> tool_;
  bool handles_ = false, toolHasMouse_ = false;
  KeyOffer keyOffer_ = KeyOffer::None;
  NavigationStyle navigation_ = NavigationStyle::Blossom;
  PickMode pickMode_ = PickMode::Feature;
  Pick hovered_;
  std::optional<CutPlane> section_;
  DragAction drag_ = DragAction::None;
  bool pressed_ = false, moved_ = false;
  QPointF pressedAt_, lastAt_;
  std::optional<Vec3> pivot_;  // what the camera turns about

  double scale_ = 1;  // device pixels per pixel
  double lastFrameMs_ = 0;
  Smoothing smoothing_;
  bool multisampled_ = false, tooSlow_ = false;  // for it
  QTimer settle_, next_, arrival_;
  std::optional<std::uint64_t> frame_;  // that is being drawn
  Turn frameTurn_;                      // how the camera stands in it
  bool outdated_ = false;               // it is, before it is there
  bool blank_ = true;                   // nothing is in the picture yet
  QImage before_;                       // what is shown until then
  bool changed_ = false;                // the picture, since it was painted
  // Where a frame takes too long, the camera moves in frames of half the size.
  bool moving_ = false, slow_ = false;
  QSize frameSize_;
  QElapsedTimer frameTimer_;
  int framesDrawn_ = 0;
};

}  // namespace blossom::ui
