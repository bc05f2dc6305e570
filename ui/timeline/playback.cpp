#include "ui/timeline/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace blossom::ui {

namespace {

int scaledFrame(int frame, int count, int wanted) {
  if (count < 2 || wanted < 2) return 0;
  return static_cast<int>(std::lround(static_cast<double>(frame) * (wanted - 1) / (count - 1)));
}

}  // namespace

Playback::Playback(QObject* parent) : QObject(parent) {
  clock_.setTimerType(Qt::PreciseTimer);
  connect(&clock_, &QTimer::timeout, this, &Playback::advance);
}

int Playback::frameOf(int frames) const { return scaledFrame(frame_, count_, frames); }

void Playback::setCount(int frames) {
  if (frames == count_) return;
  // Of a sequence that goes and comes back, by undo for instance, the same frame is seen.
  if (count_ > 1 && frames < 2) before_ = {frame_, count_};
  frame_ = count_ < 2 && frames == before_.second ? before_.first : scaledFrame(frame_, count_, frames);
  count_ = frames;
  if (count_ < 2) clock_.stop();
  emit changed();
  if (count_ > 1 && std::exchange(awaited_, false)) setPlaying(true);
}

void Playback::show(int frame) {
  const int kept = std::clamp(frame, 0, std::max(0, count_ - 1));
  if (kept == frame_) return;
  frame_ = kept;
  emit moved();
}

void Playback::setOffered(bool offered) {
  if (offered == offered_) return;
  offered_ = offered;
  emit changed();
}

void Playback::setPlaying(bool play) {
  if (play && count_ < 2 && offered_) {
    awaited_ = true;
    emit wanted();
  }
  if (play == playing() || (play && count_ < 2)) return;
  if (play && frame_ == count_ - 1) show(0);
  if (play)
    clock_.start(frameMs());
  else
    clock_.stop();
  emit changed();
}

void Playback::setLooping(bool looping) {
  looping_ = looping;
  emit changed();
}

void Playback::setFramesPerSecond(int rate) {
  framesPerSecond_ = std::clamp(rate, 1, 60);
  if (playing()) clock_.start(frameMs());
  emit changed();
}

void Playback::setOnionSkin(bool on) {
  onionSkin_ = on;
  emit changed();
}

// Timer events that a slow frame delays are not made up for: a sequence that cannot keep its pace plays slower, whole.
void Playback::advance() {
  if (frame_ + 1 == count_ && !looping_) return setPlaying(false);
  show((frame_ + 1) % count_);
  if (frameMs() != clock_.interval()) clock_.setInterval(frameMs());
}

/// How long the frame shown stays. At an even pace all of them take their share of a second.
int Playback::frameMs() const {
  const auto k = static_cast<std::size_t>(frame_);
  if (beginnings_.size() != static_cast<std::size_t>(count_)) return 1000 / framesPerSecond_;
  const double end = k + 1 < beginnings_.size() ? beginnings_[k + 1] : 1;
  const double share = (end - beginnings_[k]) * static_cast<double>(beginnings_.size());
  return static_cast<int>(std::lround(1000.0 / framesPerSecond_ * share));
}

}  // namespace blossom::ui
