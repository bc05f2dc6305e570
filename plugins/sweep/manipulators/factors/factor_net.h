#pragma once
#include <QWidget>
#include <optional>
#include <set>

#include "manipulators/factors/factor_layout.h"

class QPainter;

namespace blossom::sweep {

/// The poles of a factor over the (u, v) domain, u to the right and v upwards: knot lines, the supports of the chosen poles,
/// and a sign of each pole's value. A click chooses a pole, with Ctrl or Shift one more or less, a drag beside poles all
/// inside a frame; a drag from a pole changes the chosen ones. A click in the margin inserts a knot.
class FactorNet final : public QWidget {
  Q_OBJECT
 public:
  using Chosen = std::set<FactorPole>;
  explicit FactorNet(QWidget* parent = nullptr);

  /// Poles that are no longer there are no longer chosen.
  void setPoles(FactorLayout);
  /// For each pole, row by row: its size as a share from 0 to 1, and a direction in degrees, or none.
  void setSigns(std::vector<double> sizes, std::vector<double> directions);
  void choose(Chosen);
  [[nodiscard]] const Chosen& chosen() const { return chosen_; }
  [[nodiscard]] const FactorLayout& poles() const { return layout_; }
  [[nodiscard]] QSize sizeHint() const override { return {300, 190}; }

  /// Of a pole, and of a place in the margin where a click inserts this knot, in pixels.
  Q_INVOKABLE QPointF polePosition(int row, int column) const;
  Q_INVOKABLE QPointF knotPosition(bool alongU, double knot) const;

 signals:
  void chosenChanged();
  void dragged(const QPointF& pixels);  ///< to the right and upwards, since the chosen poles were taken hold of
  void dropped();
  void cancelled();
  void knotWanted(bool alongU, double knot);
  void hovered(const QString& what);  ///< what a click or drag would do

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  bool event(QEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  enum class Drag { None, Poles, Frame };
  struct Knot {
    bool alongU = false;
    double at = 0;
  };
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] QPointF pixelsOf(double u, double v) const;
  [[nodiscard]] std::optional<FactorPole> poleAt(const QPointF&) const;
  [[nodiscard]] std::optional<Knot> knotAt(const QPointF&) const;
  [[nodiscard]] Chosen inside(const QRectF&) const;
  void setChosen(Chosen);
  void takePole(const FactorPole&, bool extend);
  bool step(int key);
  void giveUp();
  void hoverAt(const QPointF&);
  void paintSupports(QPainter&) const;
  void paintKnots(QPainter&) const;
  [[nodiscard]] double dotScale() const;
  void paintPoles(QPainter&) const;
  void paintCandidate(QPainter&) const;

  FactorLayout layout_;
  std::vector<double> sizes_, directions_;
  Chosen chosen_, before_;  ///< `before_`: when a frame was begun
  std::optional<FactorPole> under_;
  std::optional<Knot> candidate_;
  Drag drag_ = Drag::None;
  QPointF pressed_, now_;
  bool moved_ = false, toggle_ = false;
};

}  // namespace blossom::sweep
