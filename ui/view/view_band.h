#pragma once
#include <QWidget>

namespace blossom::ui {

/// The rectangle that is drawn over the view to select with. Drawn to the right it takes what lies wholly inside, to the
/// left what it touches, shown by its dashed outline.
class SelectionBand : public QWidget {
  Q_OBJECT
 public:
  explicit SelectionBand(QWidget* parent);
  void span(QPointF from, QPointF to);
  [[nodiscard]] bool crossing() const { return crossing_; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  bool crossing_ = false;
};

}  // namespace blossom::ui
