#pragma once
#include <QAbstractButton>
#include <QColor>

namespace blossom::ui {

/// A small field of one colour; a click asks for another one.
class Swatch final : public QAbstractButton {
  Q_OBJECT
 public:
  explicit Swatch(QWidget* parent = nullptr);
  void setColor(const QColor&);  ///< an invalid one shows that there is none
  [[nodiscard]] const QColor& color() const { return color_; }
  [[nodiscard]] QSize sizeHint() const override { return {30, 27}; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QColor color_;
};

}  // namespace blossom::ui
