#pragma once
#include <QLabel>

namespace blossom::ui {

/// The name of a parameter. A number's name can be dragged sideways to change the number.
class FieldLabel : public QLabel {
  Q_OBJECT
 public:
  explicit FieldLabel(const QString& text, QWidget* parent = nullptr);
  void setScrubbable(bool);
  /// Ignores the mouse until the button is released.
  void cancelScrub() { pressed_ = scrubbing_ = false; }

 signals:
  void scrubStarted();
  void scrubbed(int pixels, Qt::KeyboardModifiers);  ///< distance from the start
  void scrubEnded();
  void clicked();

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;

 private:
  bool scrubbable_ = false;
  bool pressed_ = false;
  bool scrubbing_ = false;
  int from_ = 0;
};

}  // namespace blossom::ui
