#pragma once
#include "ui/tools/floating_panel.h"

class QLabel;
class QToolButton;

namespace blossom::minkowski {

class PathPad;

/// The card over the view while a morph is selected: t and area of the shape that is seen, the switch of the ladder, and the
/// pad of the path.
class MorphCard final : public ui::FloatingPanel {
  Q_OBJECT
 public:
  explicit MorphCard(QWidget* view);

  void setFigures(const QString&);  ///< empty: there are none
  void setLadder(bool on);
  void setPath(bool open, bool possible);
  void setNote(const QString&);  ///< about ladder and path; empty: none
  [[nodiscard]] PathPad& pad() { return *pad_; }

 signals:
  void ladderWanted(bool on);
  void pathWanted(bool open);

 private:
  static void tell(QLabel*, const QString&);

  QLabel *figures_, *note_;
  QToolButton *ladder_, *path_;
  PathPad* pad_;
};

}  // namespace blossom::minkowski
