#pragma once
#include <QLineEdit>

namespace blossom::ui {

/// A line edit for a number: arrow keys, page keys and the wheel (when it is meant for it) emit steps, which end when the
/// key is released or the wheel rests.
class NumberLine : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberLine(QWidget* parent = nullptr);

 signals:
  void stepped(double steps, Qt::KeyboardModifiers);
  void stepsEnded();

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void keyReleaseEvent(QKeyEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  void timerEvent(QTimerEvent*) override;

 private:
  void endSteps();
  bool stepping_ = false;
  int wheelTimer_ = 0;
};

}  // namespace blossom::ui
