#pragma once
#include <optional>
#include <vector>

#include "ui/look/passing_bar.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace blossom::ui {

class GrooveSlider;
class KeyMarks;
class Playback;

/// Frames of keys, counted from 1, in a sequence of so many frames.
struct TimelineKeys {
  std::vector<int> frames;
  int count = 0;
};

/// The bar under the view while a sequence is shown: play, scrub, speed, loop, onion skin, and the keys of a sequence that
/// has some.
class TimelineBar : public PassingBar {
  Q_OBJECT
 public:
  explicit TimelineBar(Playback&, QWidget* parent = nullptr);
  void setKeys(std::optional<TimelineKeys>);  ///< nothing: what is selected can have none
  [[nodiscard]] KeyMarks& marks() { return *marks_; }

 signals:
  void keyWanted(int frame);    ///< counted from 1, of the sequence of the keys
  void keyUnwanted(int frame);  ///< the one at that frame

 private:
  void build();
  void connectButtons();
  void refresh();
  void tellFrame();
  void refreshKeys();
  [[nodiscard]] int keyFrame() const;

  Playback& playback_;
  QToolButton *first_, *back_, *play_, *forward_, *last_, *loop_, *onion_;
  QToolButton* key_;
  GrooveSlider* slider_;
  KeyMarks* marks_;
  std::optional<TimelineKeys> keys_;
  QLabel* frame_;
  QComboBox* pace_;
};

}  // namespace blossom::ui
