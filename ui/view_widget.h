#pragma once
#include <vtkSmartPointer.h>

#include <QOpenGLWidget>
#include <QTimer>
#include <map>
#include <vector>

#include "document/document.h"
#include "scene/scene.h"
#include "ui/camera_control.h"
#include "ui/ground_grid.h"

class vtkActor;
class vtkGenericOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;

namespace blossom::ui {

class Tool;
class ViewCube;

/// How a shape takes part in what is being done, and thereby its colour.
enum class ItemRole { Plain, Made, Control };

struct ViewItem {
  FeatureId id;
  SceneData scene;
  ItemRole role = ItemRole::Plain;
};

/// The canvas: VTK draws into the frame buffer of this widget. Geometry is sent to the graphics card once; orbiting only
/// moves the camera, and nothing is drawn while nothing changes.
class ViewWidget : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit ViewWidget(QWidget* parent = nullptr);
  ~ViewWidget() override;

  void setItems(const std::vector<ViewItem>&);
  void setOverlay(std::vector<vtkSmartPointer<vtkProp>>);
  /// Gets mouse and keys first until another is set; nullptr: none. Not owned.
  void setTool(Tool* tool) {
    tool_ = tool;
    update();
  }
  void setLook(const Look&);
  void setGridVisible(bool);
  void setParallel(bool);
  [[nodiscard]] bool parallel() const { return camera_.parallel(); }
  void fit(bool animated = true);
  void lookFrom(const QString& view, bool animated = true);  ///< a name of viewNames(); frames everything
  void zoomBy(double factor);
  [[nodiscard]] const CameraControl& camera() const { return camera_; }
  [[nodiscard]] double gridSpacing() const { return grid_.spacing(); }  ///< mm
  [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
  [[nodiscard]] int framesDrawn() const { return framesDrawn_; }
  [[nodiscard]] bool sharp() const { return sharp_; }         ///< false while the camera moves and frames are drawn faster
  [[nodiscard]] QString problem() const { return problem_; }  ///< why nothing can be drawn; empty when all is well

  /// What the mouse would do when it rests on the view.
  static QString idleHint();

 signals:
  void picked(const QString& feature, bool extend);  ///< empty: the canvas itself
  void hint(const QString& text);
  void whereabouts(const QString& text);  ///< cursor on the ground and grid
  void filesDropped(const QStringList& files);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  struct Shown {
    SceneData scene;
    ItemRole role = ItemRole::Plain;
    std::vector<vtkSmartPointer<vtkActor>> actors;
  };
  enum class Drag { None, Orbit, Pan };

  void releaseGl();
  void show(Shown&);
  void hide(Shown&);
  void paintRole(const Shown&) const;
  [[nodiscard]] Look scaledLook() const;
  [[nodiscard]] FeatureId featureAt(QPointF) const;
  [[nodiscard]] std::vector<Vec3> everything() const;
  void tellWhereabouts(QPointF);
  void placeCube();
  void keepGridInSight();

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  std::map<FeatureId, Shown> shown_;
  std::vector<vtkSmartPointer<vtkProp>> overlay_;
  GroundGrid grid_;
  Look look_ = Look::dark();
  CameraControl camera_;
  Tool* tool_ = nullptr;
  ViewCube* cube_;
  Drag drag_ = Drag::None;
  QPointF pressedAt_, lastAt_;
  bool moved_ = false;
  double scale_ = 1;  // device pixels per pixel
  double lastFrameMs_ = 0, sharpFrameMs_ = 0;
  bool sharp_ = false;  // edges are smoothed; left out at first, and while the camera moves where that would stutter
  QTimer settle_;
  int framesDrawn_ = 0;
  QString problem_;
};

}  // namespace blossom::ui
