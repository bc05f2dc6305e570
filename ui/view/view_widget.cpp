#include "ui/view/view_widget.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <algorithm>

#include "ui/view/view_band.h"
#include "ui/view/view_cube.h"

namespace blossom::ui {

namespace {

constexpr int samples = 4;       // of each pixel, where the graphics are fast
constexpr double fastMs = 2;     // a frame without them that takes no longer can have them
constexpr double fluentMs = 20;  // a frame with them that takes longer had better not
constexpr int restMs = 140;      // after the last change

}  // namespace

ViewWidget::ViewWidget(QWidget* parent)
    : QOpenGLWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      items_(renderer_),
      hoverLight_(renderer_),
      selected_(renderer_),
      cube_(new ViewCube(this)),
      band_(new SelectionBand(this)) {
  quietVtk();
  setUpdateBehavior(PartialUpdate);  // the mean of frames grows in the frame buffer
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  buildRenderer();
  settle_.setSingleShot(true);
  connect(&settle_, &QTimer::timeout, this, qOverload<>(&ViewWidget::update));
  connect(&camera_, &CameraControl::moved, this, &ViewWidget::cameraMoved);
  connect(cube_, &ViewCube::sideChosen, this, [this](const QString& view) { lookFrom(view); });
  connect(cube_, &ViewCube::hint, this, &ViewWidget::hint);
}

ViewWidget::~ViewWidget() {
  releaseGl();
  if (context()) disconnect(context(), nullptr, this, nullptr);
}

void ViewWidget::buildRenderer() {
  // Qt makes the context current before it calls us.
  window_->SetOwnContext(false);
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetSupportsOpenGL(1);
  window_->SetFrameBlitModeToNoBlit();
  window_->AddRenderer(renderer_);
  renderer_->AddActor(grid_.actor());
  setUpRenderer(renderer_, look_);
  applyLook();
}

void ViewWidget::cameraMoved() {
  cube_->setTurn(camera_.turn());
  redraw();
}

void ViewWidget::redraw() {
  smoothing_.restart();
  settle_.stop();
  update();
}

void ViewWidget::releaseGl() {
  if (!isValid()) return;
  makeCurrent();
  smoothing_.release();
  window_->Finalize();
  doneCurrent();
}

void ViewWidget::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewWidget::releaseGl, Qt::UniqueConnection);
  if (!window_->InitializeFromCurrentContext()) {
    problem_ = tr("The graphics driver has no OpenGL 3.2, which the view needs.");
    for (const std::string& line : takeVtkMessages()) problem_ += QLatin1Char('\n') + QString::fromStdString(line);
  }
}

void ViewWidget::resizeGL(int, int) {
  window_->SetSize(static_cast<int>(width() * devicePixelRatioF()), static_cast<int>(height() * devicePixelRatioF()));
  camera_.setViewSize(size());
  redraw();
  if (scale_ == devicePixelRatioF()) return;
  scale_ = devicePixelRatioF();  // it changes with the screen
  applyLook();
}

void ViewWidget::paintGL() {
  if (!problem_.isEmpty() || sharp()) return;  // the frame buffer has it still
  QElapsedTimer timer;
  timer.start();
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera_.applyTo(&camera);
  if (items_.incomplete()) {
    items_.bringNextPiece();
    keepGridLast();
    smoothing_.restart();
  }
  grid_.follow(camera_.target(), camera_.millimetresPerPixel(), std::max(width(), height()), look_);
  renderer_->ResetCameraClippingRange();
  keepGridInSight();
  items_.setCulling(!items_.extent().contains(Vec3(camera.GetPosition())));
  items_.placeCaps(camera, camera_.millimetresPerPixel());
  window_->SetMultiSamples(multisampled_ ? samples : 0);
  const QPointF offset = smoothing_.offset();
  camera.SetWindowCenter(2 * offset.x() / window_->GetSize()[0], 2 * offset.y() / window_->GetSize()[1]);
  window_->Render();
  camera.SetWindowCenter(0, 0);
  smoothing_.take(*window_, defaultFramebufferObject());
  context()->functions()->glFinish();
  lastFrameMs_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  ++framesDrawn_;
  if (items_.incomplete()) return QTimer::singleShot(0, this, &ViewWidget::redraw);
  chooseSmoothing();
}

// Fast graphics smooth every frame at once; for others the mean of several is taken when nothing changes any more.
void ViewWidget::chooseSmoothing() {
  if (multisampled_ && lastFrameMs_ > fluentMs) {
    multisampled_ = false;
    tooSlow_ = true;
  } else if (!multisampled_ && !tooSlow_ && framesDrawn_ > 1 && lastFrameMs_ < fastMs) {
    multisampled_ = true;
    return redraw();
  }
  if (!sharp()) settle_.start(smoothing_.taken() == 1 ? restMs : 0);
}

// The clipping range is made for the shapes; the ground reaches farther.
void ViewWidget::keepGridInSight() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  if (!grid_.actor()->GetVisibility() || camera.GetParallelProjection()) return;
  const double distance = camera.GetDistance();
  const double* range = camera.GetClippingRange();
  const double far = std::max(range[1], distance + grid_.reach() * 1.5);
  camera.SetClippingRange(std::max(std::min(range[0], distance * 0.2), far * 5e-4), far);
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  placeCube();
}

void ViewWidget::placeCube() { cube_->move(width() - cube_->width() - 14, 12); }

Look ViewWidget::scaledLook() const {
  Look look = look_;
  look.edgeWidth *= scale_;
  look.pointSize *= scale_;
  return look;
}

}  // namespace blossom::ui
