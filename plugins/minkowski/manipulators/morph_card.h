#pragma once
#include "ui/tools/floating_panel.h"

class QLabel;
class QToolButton;

namespace blossom::minkowski {

class InfluenceChart;

/// The card over the view while a morph is selected: t and area of the shape that is seen, the switch of the ladder, and the
/// influences of the control shapes when they are wanted.
class MorphCard final : public ui::FloatingPanel {
  Q_OBJECT
 public:
  explicit MorphCard(QWidget* view);

  void setFigures(const QString&);  ///< empty: there are none
  void setLadder(bool on);
  void setNote(const QString&);                ///< about the ladder; empty: none
  void setInfluences(bool on, bool possible);  ///< on: wanted; possible: the chart shows some
  [[nodiscard]] InfluenceChart& chart() const { return *chart_; }

 signals:
  void ladderWanted(bool on);
  void influencesWanted(bool on);

 private:
  static void tell(QLabel*, const QString&);

  QLabel *figures_, *note_;
  QToolButton *ladder_, *influences_;
  InfluenceChart* chart_;
};

}  // namespace blossom::minkowski
