#pragma once
#include <utility>

#include "ui/tools/floating_panel.h"
#include "ui/tools/section_plane.h"

class QAbstractButton;
class QButtonGroup;
class QLabel;
class QLineEdit;
class QToolButton;

namespace blossom::ui {

class GrooveSlider;

/// Direction, offset and side of the section in one row; every control can be reached with Tab.
class SectionPanel : public FloatingPanel {
  Q_OBJECT
 public:
  explicit SectionPanel(QWidget* view);

  void show(const SectionPlane&, std::pair<double, double> range, bool pickingFace);

 signals:
  void axisChosen(blossom::ui::SectionAxis axis);
  void offsetChosen(double offset);
  void flipped();
  void turnedOff();

 private:
  void build();
  void type();

  QButtonGroup* axes_;
  QLineEdit* offset_;
  GrooveSlider* slider_;
  QToolButton *flip_, *off_;
  QLabel* problem_;
  std::pair<double, double> range_{0, 1};
  double shown_ = 0;
};

}  // namespace blossom::ui
