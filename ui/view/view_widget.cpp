#include "ui/view/view_widget.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

#include "ui/view/painter.h"
#include "ui/view/rehearsal.h"
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
    : QWidget(parent),
      painter_(Painter::shared()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      items_(renderer_),
      hoverLight_(renderer_),
      selected_(renderer_),
      cube_(new ViewCube(this)),
      band_(new SelectionBand(this)) {
  quietVtk();
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  buildRenderer();
  settle_.setSingleShot(true);
  connect(&settle_, &QTimer::timeout, this, qOverload<>(&ViewWidget::update));
  connect(&camera_, &CameraControl::moved, this, &ViewWidget::cameraMoved);
  connect(cube_, &ViewCube::sideChosen, this, [this](const QString& view) { lookFrom(view); });
  connect(cube_, &ViewCube::hint, this, &ViewWidget::hint);
  QTimer::singleShot(0, this, [this] { rehearse(*painter_); });
}

ViewWidget::~ViewWidget() { painter_->remove(renderer_); }

void ViewWidget::buildRenderer() {
  painter_->add(renderer_);
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

QString ViewWidget::problem() const { return painter_->problem(); }

void ViewWidget::paintEvent(QPaintEvent* event) {
  if (!problem().isEmpty()) return paintProblem(*event);
  const bool changed = bringUpToDate();
  QPainter(this).drawImage(QPointF(0, 0), picture_);
  // Painting is done, and the window is shown, when this event has been handled.
  if (changed) QMetaObject::invokeMethod(this, &ViewWidget::framePainted, Qt::QueuedConnection);
}

void ViewWidget::paintProblem(const QPaintEvent& event) {
  QPainter painter(this);
  painter.fillRect(event.rect(), palette().color(QPalette::Window));
  painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, problem());
}

QImage ViewWidget::grabFramebuffer() {
  if (problem().isEmpty()) bringUpToDate();
  return picture_;
}

void ViewWidget::sizePicture() {
  const double scale = devicePixelRatioF();
  const QSize pixels(static_cast<int>(width() * scale), static_cast<int>(height() * scale));
  if (picture_.size() == pixels && scale == scale_) return;
  picture_ = QImage(pixels, QImage::Format_RGB32);
  picture_.setDevicePixelRatio(scale);
  smoothing_.restart();
  if (scale == scale_) return;
  scale_ = scale;  // it changes with the screen
  applyLook();
}

bool ViewWidget::bringUpToDate() {
  sizePicture();
  if (sharp() || picture_.isNull()) return false;
  QElapsedTimer timer;
  timer.start();
  prepareFrame();
  const bool changed = smoothing_.take(painter_->draw(renderer_, picture_.size(), multisampled_ ? samples : 0), picture_);
  lastFrameMs_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  ++framesDrawn_;
  if (items_.incomplete())
    QTimer::singleShot(0, this, &ViewWidget::redraw);
  else
    chooseSmoothing();
  return changed;
}

void ViewWidget::prepareFrame() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera_.applyTo(&camera);
  if (items_.incomplete()) {
    items_.bringNextPiece();
    keepGridLast();
    smoothing_.restart();
  }
  grid_.follow(camera_.target(), camera_.millimetresPerPixel(), std::max(width(), height()), look_);
  camera.SetWindowCenter(0, 0);
  renderer_->ResetCameraClippingRange();
  keepGridInSight();
  items_.setCulling(!items_.extent().contains(Vec3(camera.GetPosition())));
  items_.placeCaps(camera, camera_.millimetresPerPixel());
  const QPointF offset = smoothing_.offset();
  camera.SetWindowCenter(2 * offset.x() / picture_.width(), 2 * offset.y() / picture_.height());
}

// Fast graphics smooth every frame at once; for others the mean of several is taken when nothing changes any more.
void ViewWidget::chooseSmoothing() {
  if (multisampled_ && lastFrameMs_ > fluentMs) {
    multisampled_ = false;
    tooSlow_ = true;
  } else if (!multisampled_ && !tooSlow_ && !items_.empty() && lastFrameMs_ < fastMs) {
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
  QWidget::resizeEvent(event);
  placeCube();
  camera_.setViewSize(size());
  redraw();
}

void ViewWidget::placeCube() { cube_->move(width() - cube_->width() - 14, 12); }

Look ViewWidget::scaledLook() const {
  Look look = look_;
  look.edgeWidth *= scale_;
  look.pointSize *= scale_;
  return look;
}

}  // namespace blossom::ui
