#pragma once
#include <QScrollArea>

namespace blossom::ui {

/// Shows a column as high as it is, and scrolls it where there is no room for that.
class FittingScroll : public QScrollArea {
  Q_OBJECT
 public:
  explicit FittingScroll(QWidget* column, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject*, QEvent*) override;
};

}  // namespace blossom::ui
