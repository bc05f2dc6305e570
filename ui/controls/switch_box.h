#pragma once
#include <QCheckBox>

namespace blossom::ui {

/// A check box drawn as a switch with "on" or "off" beside it.
class SwitchBox final : public QCheckBox {
  Q_OBJECT
 public:
  explicit SwitchBox(QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;
  [[nodiscard]] bool hitButton(const QPoint&) const override;
};

}  // namespace blossom::ui
