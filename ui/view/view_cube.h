#pragma once
#include <QPolygonF>
#include <QWidget>
#include <vector>

#include "scene/camera.h"

namespace blossom::ui {

/// The cube in the corner of the view: shows how the view is turned; a click on a side looks from there.
class ViewCube : public QWidget {
  Q_OBJECT
 public:
  explicit ViewCube(QWidget* parent);
  void setTurn(const Turn&);
  [[nodiscard]] QSize sizeHint() const override { return {104, 104}; }

 signals:
  void sideChosen(const QString& view);
  void hint(const QString& text);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  struct Side {
    QString view;
    QPolygonF outline;  // the corner at the label's upper left first, then clockwise as one reads it
    double facing = 0;  // cosine to the camera
  };
  [[nodiscard]] std::vector<Side> visibleSides() const;
  [[nodiscard]] QPointF project(const Vec3&) const;
  [[nodiscard]] QString sideAt(QPointF) const;
  void drawAxes(QPainter&) const;

  Turn turn_{35, 28};
  QString hovered_;
};

}  // namespace blossom::ui
