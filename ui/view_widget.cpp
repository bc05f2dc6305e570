#include "ui/view_widget.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <algorithm>

#include "ui/view_band.h"
#include "ui/view_cube.h"

namespace blossom::ui {

namespace {

constexpr int samplesAtRest = 4;
constexpr double fluentMs = 20;  // a smoothed frame that takes longer waits until the camera rests

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
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  buildRenderer();
  settle_.setSingleShot(true);
  settle_.setInterval(140);
  connect(&settle_, &QTimer::timeout, this, [this] {
    sharp_ = true;
    update();
  });
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
  if (sharpFrameMs_ > fluentMs) {
    sharp_ = false;
    settle_.start();
  }
  update();
}

void ViewWidget::releaseGl() {
  if (!isValid()) return;
  makeCurrent();
  window_->Finalize();
  doneCurrent();
}

void ViewWidget::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewWidget::releaseGl, Qt::UniqueConnection);
  settle_.start();
  if (!window_->InitializeFromCurrentContext()) {
    problem_ = tr("The graphics driver has no OpenGL 3.2, which the view needs.");
    for (const std::string& line : takeVtkMessages()) problem_ += QLatin1Char('\n') + QString::fromStdString(line);
  }
}

void ViewWidget::resizeGL(int, int) {
  window_->SetSize(static_cast<int>(width() * devicePixelRatioF()), static_cast<int>(height() * devicePixelRatioF()));
  camera_.setViewSize(size());
  if (scale_ == devicePixelRatioF()) return;
  scale_ = devicePixelRatioF();  // it changes with the screen
  applyLook();
}

void ViewWidget::paintGL() {
  if (!problem_.isEmpty()) return;
  QElapsedTimer timer;
  timer.start();
  camera_.applyTo(renderer_->GetActiveCamera());
  grid_.follow(camera_.target(), camera_.millimetresPerPixel(), std::max(width(), height()), look_);
  renderer_->ResetCameraClippingRange();
  keepGridInSight();
  items_.setCulling(!sharp_);
  items_.placeCaps(*renderer_->GetActiveCamera(), camera_.millimetresPerPixel());
  window_->SetMultiSamples(sharp_ ? samplesAtRest : 0);
  window_->Render();
  auto* gl = context()->extraFunctions();
  const int w = window_->GetSize()[0], h = window_->GetSize()[1];
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, window_->GetDisplayFramebuffer()->GetFBOIndex());
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glFinish();
  lastFrameMs_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  if (sharp_) sharpFrameMs_ = lastFrameMs_;
  ++framesDrawn_;
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
