#pragma once
#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>

#include "manipulators/path_points.h"

class QPainter;

namespace blossom::minkowski {

/// A path through the arguments of a blossom, drawn and edited. Of two arguments it is a line in their square, t1 to the
/// right and t2 up, whose diagonal is the ordinary morph; of any other number there is a curve of each over u, and points
/// move up and down. A double click puts a point in, Delete or a right click takes the chosen one out, arrow keys move it,
/// Esc gives a drag up.
class PathPad final : public QWidget {
  Q_OBJECT
 public:
  explicit PathPad(QWidget* parent = nullptr);

  /// Not while a point is dragged.
  void setPath(const PathPoints&);
  void setPlace(std::optional<double> u);  ///< where the morph is seen
  /// Ends a drag and says nothing: for who shows the path no more.
  void cancel();
  [[nodiscard]] bool dragging() const { return before_.has_value(); }
  [[nodiscard]] const PathPoints& path() const { return path_; }
  /// Where a number of a point stands, in pixels: with two arguments the whole point.
  [[nodiscard]] Q_INVOKABLE QPointF pixelsOf(int point, int argument) const;
  [[nodiscard]] QSize sizeHint() const override { return {230, 230}; }

 signals:
  void dragged();   ///< the path is to be shown
  void changed();   ///< it is to be kept
  void reverted();  ///< a drag was given up

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  bool event(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  /// A number of a point; in the square its first stands for both.
  struct Spot {
    std::size_t point, argument;
    friend bool operator==(const Spot&, const Spot&) = default;
  };

  [[nodiscard]] bool square() const { return path_.arguments() == 2; }
  [[nodiscard]] QRectF field() const;
  [[nodiscard]] QPointF toPixels(double right, double up) const;
  [[nodiscard]] QPointF toValues(const QPointF& pixels, bool fine) const;
  [[nodiscard]] QPointF pixelsOf(const Spot&) const;
  [[nodiscard]] std::optional<Spot> spotAt(const QPointF& pixels) const;
  [[nodiscard]] std::size_t wayNear(const QPointF& pixels) const;
  void moveChosen(const QPointF& values);
  void insertAt(const QPointF& pixels);
  void removeChosen();
  void giveUp();
  void paintField(QPainter&) const;
  void paintSquare(QPainter&) const;
  void paintCurves(QPainter&) const;
  void paintSpot(QPainter&, const Spot&) const;
  [[nodiscard]] QColor colorOf(std::size_t argument) const;

  PathPoints path_;
  std::optional<double> place_;
  std::optional<Spot> chosen_, under_;
  std::optional<PathPoints> before_;  ///< during a drag
};

}  // namespace blossom::minkowski
