#pragma once
#include <QKeySequence>
#include <QPushButton>

namespace blossom::ui {

/// A button that, once pressed, records the next key sequence. Esc cancels.
class KeyRecorder : public QPushButton {
  Q_OBJECT
 public:
  explicit KeyRecorder(QWidget* parent = nullptr);

  void showKeys(const QList<QKeySequence>&);
  [[nodiscard]] bool recording() const { return isChecked(); }

 signals:
  void recorded(const QKeySequence&);

 protected:
  bool event(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void focusOutEvent(QFocusEvent*) override;

 private:
  void refresh();
  QString keys_;
};

}  // namespace blossom::ui
