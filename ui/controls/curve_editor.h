#pragma once
#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>
#include <vector>

class QPainter;

namespace blossom::ui {

/// Editor of a control function with draggable points. A click on the background adds a point, Delete or a right click
/// removes one; arrow keys move the chosen one.
class CurveEditor final : public QWidget {
  Q_OBJECT
 public:
  explicit CurveEditor(QWidget* parent = nullptr);
  /// Points (t, value) with t not decreasing.
  void setPoints(std::vector<QPointF>);
  void setBounds(std::optional<double> minimum, std::optional<double> maximum);
  [[nodiscard]] const std::vector<QPointF>& points() const { return points_; }
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int index);
  /// Position of a point in pixels.
  [[nodiscard]] QPointF toPixels(const QPointF&) const;
  [[nodiscard]] QSize sizeHint() const override { return {160, 110}; }

 signals:
  void dragged(const std::vector<QPointF>&);
  void changed(const std::vector<QPointF>&);
  void chosenChanged();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void fitView();
  void paintGrid(QPainter&) const;
  void removeChosen();
  [[nodiscard]] QPointF toValues(const QPointF& pixels) const;
  [[nodiscard]] int pointAt(const QPointF& pixels) const;
  [[nodiscard]] QPointF confined(QPointF, int index) const;
  void add(const QPointF& pixels);

  std::vector<QPointF> points_;
  QRectF view_{0, 0, 1, 1};  // in values
  std::optional<double> minimum_, maximum_;
  int chosen_ = -1;
  int under_ = -1;
  bool dragging_ = false;
  bool moved_ = false;
};

}  // namespace blossom::ui
