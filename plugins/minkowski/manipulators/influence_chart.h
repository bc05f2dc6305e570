#pragma once
#include <QPolygonF>
#include <QVariant>
#include <QWidget>
#include <optional>
#include <vector>

#include "kernel/morph/shape_spline.h"

namespace blossom::minkowski {

/// The influence of each control shape over t: a curve for each in the colour of its number, and a line with dots at the t
/// that is seen.
class InfluenceChart final : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariantList curves READ curves)  ///< what is drawn, in t and share: a QPolygonF for each shape
  Q_PROPERTY(QVariant cursor READ cursor)      ///< the t of the line; none where the numbers of a blossom differ
  Q_PROPERTY(QVariantList shares READ shares)  ///< of each shape in what is seen
  Q_PROPERTY(QVariantList colors READ colors)  ///< of the curves
 public:
  explicit InfluenceChart(QWidget* parent = nullptr);

  /// @param levels the numbers by which what is seen is blended
  void setMorph(const ShapeKnots&, const std::vector<double>& levels);

  [[nodiscard]] QVariantList curves() const;
  [[nodiscard]] QVariant cursor() const;
  [[nodiscard]] QVariantList shares() const;
  [[nodiscard]] QVariantList colors() const;
  /// Where in the widget a share at a t is drawn.
  Q_INVOKABLE [[nodiscard]] QPointF pixelOf(const QPointF& value) const;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  [[nodiscard]] QRectF plane() const;
  [[nodiscard]] static QColor colorOf(std::size_t shape);
  void tellShares();

  ShapeKnots spline_;
  std::vector<QPolygonF> curves_;
  std::optional<double> cursor_;
  std::vector<double> shares_;
};

}  // namespace blossom::minkowski
