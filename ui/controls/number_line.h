#pragma once
#include <QLineEdit>

namespace blossom::ui {

/// A line edit for a number: arrow keys, page keys and the wheel (when it is meant for it) emit steps, which end when the
/// key is released or the wheel rests. While nobody writes in it, a number that is too long for it is shown with as many
/// digits as there is room for, and told in full by its tool tip.
class NumberLine : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberLine(QWidget* parent = nullptr);
  [[nodiscard]] QString shownText() const;  ///< the text, or the shorter number that stands for it

 signals:
  void stepped(double steps, Qt::KeyboardModifiers);
  void stepsEnded();

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void keyReleaseEvent(QKeyEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  void timerEvent(QTimerEvent*) override;

 private:
  [[nodiscard]] QRect textRect() const;
  void endSteps();
  bool stepping_ = false;
  int wheelTimer_ = 0;
};

}  // namespace blossom::ui
