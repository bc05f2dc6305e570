#pragma once
#include <QObject>
#include <QTimer>
#include <utility>
#include <vector>

namespace blossom::ui {

/// The visible frame of the sequences in a document, and their playback. All sequences share one frame count, that of the
/// longest.
class Playback : public QObject {
  Q_OBJECT
 public:
  explicit Playback(QObject* parent = nullptr);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int frame() const { return frame_; }
  [[nodiscard]] bool playing() const { return clock_.isActive(); }
  [[nodiscard]] bool looping() const { return looping_; }
  [[nodiscard]] int framesPerSecond() const { return framesPerSecond_; }
  [[nodiscard]] bool onionSkin() const { return onionSkin_; }
  /// The frame of a sequence with `frames` frames of its own, at least 1.
  [[nodiscard]] int frameOf(int frames) const;

  void setCount(int frames);  ///< keeps the position as a fraction of the whole; 0 stops
  /// When each frame begins, as a share of one run, from 0. Frames of another count, or none: all take as long.
  void setPace(std::vector<double> beginnings) { beginnings_ = std::move(beginnings); }
  /// Whether something is shown that can be made a sequence: then playing is possible, and asks for it.
  void setOffered(bool);
  [[nodiscard]] bool playable() const { return count_ > 1 || offered_; }
  /// What was wanted has not come: nothing plays by itself when a sequence comes later.
  void forgetWish() { awaited_ = false; }
  void show(int frame);   ///< clamped to the count
  void setPlaying(bool);  ///< from the start when it is at the end
  void setLooping(bool looping);
  void setFramesPerSecond(int);  ///< clamped to 1..60
  void setOnionSkin(bool);

 signals:
  void moved();    ///< another frame is shown
  void changed();  ///< count, playing, looping, speed or onion skin
  void wanted();   ///< what is offered is to be played; it is, as soon as its frames are there

 private:
  void advance();
  [[nodiscard]] int frameMs() const;

  int count_ = 0, frame_ = 0;
  std::pair<int, int> before_;  ///< frame and count of the sequence that was there last
  bool looping_ = true, onionSkin_ = false;
  bool offered_ = false, awaited_ = false;
  int framesPerSecond_ = 24;
  std::vector<double> beginnings_;
  QTimer clock_;
};

}  // namespace blossom::ui
