#pragma once
#include <QWidget>
#include <optional>

#include "scene/surface_display.h"

namespace blossom::ui {

/// The scale of the colours over the view, at its lower right: which curvature, the values at its ends, and the one under
/// the mouse. Lets the mouse through.
class CurvatureLegend : public QWidget {
  Q_OBJECT
 public:
  explicit CurvatureLegend(QWidget* parent);
  /// @param range empty: it hides
  void showScale(SurfaceDisplay, const std::optional<CurvatureRange>& range);
  /// Of the place under the mouse; empty: none.
  void setValue(std::optional<double> value);
  [[nodiscard]] const std::optional<CurvatureRange>& range() const { return range_; }
  [[nodiscard]] std::optional<double> value() const { return value_; }
  [[nodiscard]] QSize sizeHint() const override { return {168, 212}; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  [[nodiscard]] QString title() const;
  [[nodiscard]] double heightOf(double value) const;  ///< pixels from the upper edge
  SurfaceDisplay display_ = SurfaceDisplay::Plain;
  std::optional<CurvatureRange> range_;
  std::optional<double> value_;
};

}  // namespace blossom::ui
