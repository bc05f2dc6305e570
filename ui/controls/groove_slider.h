#pragma once
#include <QSlider>
#include <QStyle>

namespace blossom::ui {

/// A slider that jumps to a click on its groove and can be dragged on from there.
class GrooveSlider final : public QSlider {
  Q_OBJECT
 public:
  explicit GrooveSlider(QWidget* parent = nullptr);
  /// The middle of the handle where it stands so far along its way, in pixels from the left, and how far along that is.
  [[nodiscard]] double pixelAt(double way) const;
  [[nodiscard]] double wayAt(double pixel) const;

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
