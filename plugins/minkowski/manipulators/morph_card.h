#pragma once
#include "ui/tools/floating_panel.h"

class QBoxLayout;
class QLabel;
class QToolButton;

namespace blossom::minkowski {

class InfluenceChart;
class PathPad;

/// The card over the view while a morph is selected: t and area of the shape that is seen, the switch of the ladder, the
/// influences of the control shapes when they are wanted, and the pad of the path.
class MorphCard final : public ui::FloatingPanel {
  Q_OBJECT
 public:
  explicit MorphCard(QWidget* view);

  void setFigures(const QString&);  ///< empty: there are none
  void setLadder(bool on);
  void setInfluences(bool on, bool possible);  ///< on: wanted; possible: the chart shows some
  [[nodiscard]] InfluenceChart& chart() const { return *chart_; }
  void setPath(bool open, bool possible);
  [[nodiscard]] PathPad& pad() { return *pad_; }
  void setNote(const QString&);  ///< about ladder and path; empty: none

 signals:
  void ladderWanted(bool on);
  void influencesWanted(bool on);
  void pathWanted(bool open);

 private:
  static void tell(QLabel*, const QString&);
  void arrange();

  QLabel *figures_, *note_;
  QToolButton *ladder_, *influences_, *path_;
  QBoxLayout* head_;
  InfluenceChart* chart_;
  PathPad* pad_;
};

}  // namespace blossom::minkowski
