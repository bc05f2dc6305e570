#pragma once
#include <QSlider>

namespace blossom::ui {

/// A slider that jumps to a click on its groove and can be dragged on from there.
class GrooveSlider final : public QSlider {
  Q_OBJECT
 public:
  explicit GrooveSlider(QWidget* parent = nullptr);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;

 private:
  [[nodiscard]] QRect part(QStyle::SubControl) const;
  void follow(int x);
  int grabbed_ = 0;  ///< pixels from the middle of the handle to the mouse
};

}  // namespace blossom::ui
