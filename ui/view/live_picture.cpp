#include "ui/view/live_picture.h"

#include <vtkRenderer.h>

#include <QPainter>
#include <QWidget>
#include <chrono>
#include <utility>

#include "ui/view/painter.h"

namespace blossom::ui {

namespace {

constexpr int lookMs = 2;           // between looks whether a frame is there
constexpr int samplesPerPixel = 4;  // of each pixel, where the graphics are fast
constexpr double fastMs = 2;        // a frame without them that takes no longer can have them
constexpr double fluentMs = 20;     // a frame with them that takes longer had better not
constexpr double stutterMs = 24;    // a frame that takes longer, and the window beside it, do not look like movement
constexpr double easyMs = 5;        // a frame in haste that takes no longer needs less of it
constexpr double quickMs = 12;      // a frame that takes no longer may be begun between two changes
constexpr int restMs = 30;          // after the last change
constexpr int shortRestMs = 10;     // where frames are quick
constexpr std::chrono::microseconds soon(1500);  // worth waiting for: fast graphics need no second look

}  // namespace

LivePicture::LivePicture(QWidget& widget, PictureSubject& subject)
    : QObject(&widget), widget_(widget), subject_(subject), painter_(Painter::shared()) {
  painter_->add(&subject_.renderer());
  for (QTimer* timer : {&settle_, &next_}) timer->setSingleShot(true);
  connect(&next_, &QTimer::timeout, this, &LivePicture::beginFrame);
  connect(&settle_, &QTimer::timeout, this, &LivePicture::comeToRest);
  arrival_.setInterval(lookMs);
  arrival_.setTimerType(Qt::PreciseTimer);
  connect(&arrival_, &QTimer::timeout, this, &LivePicture::lookForFrame);
}

LivePicture::~LivePicture() { painter_->remove(&subject_.renderer()); }

QString LivePicture::problem() const { return painter_->problem(); }

bool LivePicture::detailed() const { return !outdated_ && !subject_.stale() && smoothing_.taken() > 0; }

bool LivePicture::sharp() const { return !frame_ && !subject_.stale() && smooth(); }

void LivePicture::redrawMoving() {
  moving_ = true;
  redraw();
}

void LivePicture::redrawAtRest() {
  moving_ = opened_ = false;
  redraw();
}

void LivePicture::redraw() {
  outdated_ = true;
  smoothing_.restart();
  settle_.stop();
  wantFrame();
}

void LivePicture::paint() {
  fitSize();
  if (blank_ && before_.isNull()) drawNow();  // better late than empty
  if (outdated_ || subject_.stale()) wantFrame();
  QPainter(&widget_).drawImage(widget_.rect(), blank_ ? before_ : picture_);
  if (!std::exchange(changed_, false)) return;
  // Painting is done, and the window is shown, when this event has been handled.
  untold_ = true;
  QMetaObject::invokeMethod(this, &LivePicture::tellPainted, Qt::QueuedConnection);
}

void LivePicture::tellPainted() {
  if (std::exchange(untold_, false)) emit painted();
}

const QImage& LivePicture::upToDate() {
  if (problem().isEmpty()) drawNow();
  return picture_;
}

void LivePicture::fitSize() {
  const double scale = widget_.devicePixelRatioF();
  const QSize pixels(static_cast<int>(widget_.width() * scale), static_cast<int>(widget_.height() * scale));
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
  emit scaleChanged();
}

void LivePicture::beginFrame() {
  if (frame_ || !widget_.isVisible() || !problem().isEmpty()) return;  // its arrival, or painting, asks again
  tellPainted();  // not only after the time that this frame takes: timers may come before queued calls
  subject_.bringUpToDate();
  fitSize();
  if (sharp() || picture_.isNull()) return;
  next_.stop();  // what is asked for up to here is in this frame
  frameTimer_.start();
  if (subject_.incomplete()) {
    subject_.bringNextPiece();
    smoothing_.restart();
  }
  frameHaste_ = moving_ ? haste_ : Haste::None;
  const int part = frameHaste_ == Haste::Half ? 2 : 1;
  subject_.prepareFrame(smoothing_.offset(), picture_.size(), frameHaste_ != Haste::None, 1.0 / part);
  outdated_ = false;
  frameSize_ = picture_.size() / part;
  frame_ = painter_->begin(&subject_.renderer(), frameSize_, multisampled_ ? samplesPerPixel : 0);
  if (painter_->finished(*frame_, soon)) return takeFrame();
  arrival_.start();
}

void LivePicture::comeToRest() {
  moving_ = false;
  beginFrame();
}

void LivePicture::lookForFrame() {
  if (!frame_ || painter_->finished(*frame_)) takeFrame();
}

void LivePicture::takeFrame() {
  arrival_.stop();
  if (!frame_) return;
  const std::vector<std::uint32_t>* pixels = painter_->take(*frame_);
  frame_.reset();
  if (!problem().isEmpty()) return widget_.update();
  if (!pixels) return redraw();
  lastFrameMs_ = static_cast<double>(frameTimer_.nsecsElapsed()) / 1e6;
  ++framesDrawn_;
  showFrame(*pixels);
  if (subject_.incomplete() || outdated_)
    redraw();
  else if (subject_.stale())
    wantFrame();
  else
    chooseSmoothing();
}

void LivePicture::chooseHaste() {
  const auto more = haste_ == Haste::None && subject_.canBeCoarser() ? Haste::Coarse : Haste::Half;
  const auto less = haste_ == Haste::Half && subject_.canBeCoarser() ? Haste::Coarse : Haste::None;
  if (lastFrameMs_ > stutterMs)
    haste_ = more;
  else if (lastFrameMs_ <= easyMs)
    haste_ = less;
}

void LivePicture::showFrame(const std::vector<std::uint32_t>& pixels) {
  if (moving_ && frameHaste_ == haste_) chooseHaste();
  if (frameHaste_ != Haste::None)
    showEnlarged(pixels, frameSize_, picture_);
  else if (!smoothing_.take(pixels, picture_))
    return;
  changed_ = true;
  blank_ = false;
  before_ = QImage();
  emit shown();
  widget_.update();
}

/// Where a picture is needed at once: what is on its way is waited for, and drawn anew when it is out of date.
void LivePicture::drawNow() {
  takeFrame();
  subject_.bringUpToDate();
  if (smoothing_.taken() > 0 && !outdated_) return;
  moving_ = false;
  beginFrame();
  takeFrame();
}

// Fast graphics smooth every frame at once; for others the mean of several is taken when nothing changes any more.
void LivePicture::chooseSmoothing() {
  if (multisampled_ && lastFrameMs_ > fluentMs) {
    multisampled_ = false;
    tooSlow_ = true;
  } else if (!multisampled_ && !tooSlow_ && !subject_.empty() && lastFrameMs_ < fastMs) {
    multisampled_ = true;
    return redraw();
  }
  if (sharp()) {
    opened_ = opened_ || !subject_.empty();
    return;
  }
  // What has just been opened is not being moved.
  const bool quick = lastFrameMs_ <= quickMs && frameHaste_ == Haste::None;
  const int rest = quick ? shortRestMs : restMs;
  settle_.start(opened_ && smoothing_.taken() <= 1 ? rest : 0);
}

}  // namespace blossom::ui
