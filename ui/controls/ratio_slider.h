#pragma once
#include <QLineEdit>

namespace blossom::ui {

/// A value between two bounds as a draggable bar; arrow keys step, a click, F2 or Enter starts typing. Esc cancels a drag or
/// typing.
class RatioSlider : public QLineEdit {
  Q_OBJECT
 public:
  explicit RatioSlider(QWidget* parent = nullptr);
  void setRange(double minimum, double maximum);
  void setValue(double);
  /// Shows that there is no value yet.
  void setAbsent(bool);
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool typing() const { return !isReadOnly(); }

 signals:
  void dragged(double value);
  void chosen(double value);
  void takenBack();  ///< undo was asked for while it was dragged
  void typed(const QString& text);

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void keyReleaseEvent(QKeyEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  void timerEvent(QTimerEvent*) override;

 private:
  [[nodiscard]] double valueAt(double x) const;
  [[nodiscard]] bool hasMoved(const QPointF& to);
  void showValue();
  void stopTyping();
  void startTyping();
  void step(double by);
  void endSteps();

  double value_ = 0, minimum_ = 0, maximum_ = 1;
  bool absent_ = false;
  bool dragging_ = false, moved_ = false;  ///< the mouse: it is down, and has moved since
  QPointF pressedAt_;
  bool stepping_ = false;
  int wheelTimer_ = 0;
};

}  // namespace blossom::ui
