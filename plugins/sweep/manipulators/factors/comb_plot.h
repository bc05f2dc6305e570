#pragma once
#include <QColor>
#include <QPointF>
#include <QWidget>
#include <vector>

class QFontMetrics;
class QPainter;

namespace blossom::sweep {

/// A value along a parameter.
struct CombCurve {
  QColor color;
  std::vector<QPointF> points;  ///< (parameter, value), the parameters ascending
  std::vector<double> teeth;    ///< curvatures at the points, drawn as a comb; empty: teeth go down to zero
};

/// Draws curves along a parameter with their combs, all to one scale, and the place of a pole.
class CombPlot final : public QWidget {
  Q_OBJECT
 public:
  explicit CombPlot(QWidget* parent = nullptr);
  /// @param what is plotted, with its unit  @param mark parameter of the pole
  void setCurves(const QString& what, std::vector<CombCurve>, double mark);
  [[nodiscard]] QSize sizeHint() const override { return {300, 117}; }
  [[nodiscard]] QString what() const { return what_; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void fitScale();
  [[nodiscard]] QPointF pixelsOf(const QPointF&) const;
  void paintCurve(QPainter&, const CombCurve&) const;
  [[nodiscard]] QString shownTitle(const QFontMetrics&, int width) const;

  QString what_, range_;
  std::vector<CombCurve> curves_;
  double mark_ = 0;
  double left_ = 0, right_ = 1, low_ = 0, high_ = 1;
  double tallest_ = 0;  ///< the largest curvature
};

}  // namespace blossom::sweep
