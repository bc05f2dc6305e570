// How the picture of the view comes about.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>

#include "ui/view/painter.h"
#include "ui/view/view_cube.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

constexpr int samples = 4;                       // of each pixel, where the graphics are fast
constexpr double fastMs = 2;                     // a frame without them that takes no longer can have them
constexpr double fluentMs = 20;                  // a frame with them that takes longer had better not
constexpr double stutterMs = 50;                 // a frame that takes longer does not look like movement
constexpr double easyMs = 12;                    // a coarse frame that takes no longer need not be coarse
constexpr int restMs = 140;                      // after the last change
constexpr std::chrono::microseconds soon(1500);  // worth waiting for: fast graphics need no second look

}  // namespace

void ViewWidget::redrawMoving() {
  moving_ = true;
  redraw();
}

void ViewWidget::redraw() {
  outdated_ = true;
  smoothing_.restart();
  settle_.stop();
  wantFrame();
}

QImage ViewWidget::grabFramebuffer() {
  if (problem().isEmpty()) drawNow();
  return picture_;
}

void ViewWidget::sizePicture() {
  const double scale = devicePixelRatioF();
  const QSize pixels(static_cast<int>(width() * scale), static_cast<int>(height() * scale));
  if (picture_.size() == pixels && scale == scale_) return;
  if (!blank_) before_ = picture_;
  picture_ = QImage(pixels, QImage::Format_RGB32);
  picture_.setDevicePixelRatio(scale);
  frame_.reset();
  blank_ = true;
  outdated_ = true;
  smoothing_.restart();
  if (scale == scale_) return;
  scale_ = scale;  // it changes with the screen
  applyLook();
}

void ViewWidget::beginFrame() {
  if (frame_ || !isVisible() || !problem().isEmpty()) return;  // its arrival, or painting, asks again
  bringUpToDate();
  sizePicture();
  if (sharp() || picture_.isNull()) return;
  next_.stop();  // what is asked for up to here is in this frame
  frameTimer_.start();
  prepareFrame();
  outdated_ = false;
  frameSize_ = moving_ && slow_ ? picture_.size() / 2 : picture_.size();
  frame_ = painter_->begin(renderer_, frameSize_, multisampled_ ? samples : 0);
  if (painter_->finished(*frame_, soon)) return takeFrame();
  arrival_.start();
}

void ViewWidget::comeToRest() {
  moving_ = false;
  beginFrame();
}

void ViewWidget::lookForFrame() {
  if (!frame_ || painter_->finished(*frame_)) takeFrame();
}

void ViewWidget::takeFrame() {
  arrival_.stop();
  if (!frame_) return;
  const std::vector<std::uint32_t>* pixels = painter_->take(*frame_);
  frame_.reset();
  if (!problem().isEmpty()) return update();
  if (!pixels) return redraw();
  lastFrameMs_ = static_cast<double>(frameTimer_.nsecsElapsed()) / 1e6;
  ++framesDrawn_;
  showFrame(*pixels);
  if (items_.incomplete() || outdated_)
    redraw();
  else if (stale())
    wantFrame();
  else
    chooseSmoothing();
}

void ViewWidget::showFrame(const std::vector<std::uint32_t>& pixels) {
  const bool whole = frameSize_ == picture_.size();
  if (moving_) slow_ = whole ? lastFrameMs_ > stutterMs : lastFrameMs_ > easyMs;
  if (!whole)
    showEnlarged(pixels, frameSize_, picture_);
  else if (!smoothing_.take(pixels, picture_))
    return;
  cube_->setTurn(frameTurn_);
  changed_ = true;
  blank_ = false;
  before_ = QImage();
  update();
}

/// Where a picture is needed at once: what is on its way is waited for, and drawn anew when it is out of date.
void ViewWidget::drawNow() {
  takeFrame();
  bringUpToDate();
  if (smoothing_.taken() > 0 && !outdated_) return;
  moving_ = false;
  beginFrame();
  takeFrame();
}

void ViewWidget::prepareFrame() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera_.applyTo(&camera);
  frameTurn_ = camera_.turn();
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
  if (!sharp()) settle_.start(smoothing_.taken() <= 1 ? restMs : 0);
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

}  // namespace blossom::ui
