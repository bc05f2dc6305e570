#pragma once
#include "ui/tools/floating_panel.h"

class QLabel;
class QToolButton;

namespace blossom::minkowski {

/// The card over the view while a morph is selected: t and area of the shape that is seen, and the switch of the ladder.
class MorphCard final : public ui::FloatingPanel {
  Q_OBJECT
 public:
  explicit MorphCard(QWidget* view);

  void setFigures(const QString&);  ///< empty: there are none
  void setLadder(bool on);
  void setNote(const QString&);  ///< about the ladder; empty: none

 signals:
  void ladderWanted(bool on);

 private:
  static void tell(QLabel*, const QString&);

  QLabel *figures_, *note_;
  QToolButton* ladder_;
};

}  // namespace blossom::minkowski
