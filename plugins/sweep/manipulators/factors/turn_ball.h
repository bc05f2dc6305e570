#pragma once
#include <QWidget>

#include "core/vector.h"
#include "manipulators/marks/pull_ring.h"

namespace blossom::sweep {

/// A small trackball that shows the axes of a frame as the view sees them. Dragging it turns them as if it were a ball under
/// the finger; a drag along its rim turns about the line of sight.
class TurnBall final : public QWidget {
  Q_OBJECT
 public:
  explicit TurnBall(QWidget* parent = nullptr);
  /// @param orientation a quaternion of any length but 0
  void setFrame(const Vec4& orientation);
  void setFacing(const Facing& to);
  [[nodiscard]] QSize sizeHint() const override { return {84, 84}; }

 signals:
  void turned(const blossom::Vec3& turn);  ///< since it was taken hold of: the axis in space times the angle in radians
  void dropped();
  void cancelled();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  bool event(QEvent*) override;

 private:
  [[nodiscard]] double radius() const;
  [[nodiscard]] QPointF fromMiddle(const QPointF& at) const;  ///< to the right and upwards
  [[nodiscard]] Vec3 turnTo(const QPointF& at) const;

  Vec4 orientation_{1, 0, 0, 0};
  Facing facing_;
  QPointF pressed_;
  bool held_ = false, moved_ = false;
};

}  // namespace blossom::sweep
