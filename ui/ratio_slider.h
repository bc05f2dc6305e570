#pragma once
#include <QLineEdit>

namespace blossom::ui {

/// A value from 0 to 1 as a bar that is dragged; a double click types it.
class RatioSlider : public QLineEdit {
  Q_OBJECT
 public:
  explicit RatioSlider(QWidget* parent = nullptr);
  void setValue(double);
  [[nodiscard]] double value() const { return value_; }

 signals:
  void dragged(double value);
  void chosen(double value);
  void typed(const QString& text);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  [[nodiscard]] double valueAt(double x) const;
  void stopTyping();
  double value_ = 0;
  bool dragging_ = false;
};

}  // namespace blossom::ui
