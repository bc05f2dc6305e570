#pragma once
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace blossom::ui {

class GrooveSlider;
class Playback;

/// The bar under the view while a sequence is shown: play, scrub, speed, loop and onion skin.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineBar(Playback&, QWidget* parent = nullptr);

 private:
  void build();
  void connectButtons();
  void refresh();
  void tellFrame();

  Playback& playback_;
  QToolButton *first_, *back_, *play_, *forward_, *last_, *loop_, *onion_;
  GrooveSlider* slider_;
  QLabel* frame_;
  QComboBox* pace_;
};

}  // namespace blossom::ui
