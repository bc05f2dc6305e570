#pragma once
#include <QPushButton>

class QLabel;

namespace blossom::ui {

/// A button that looks like a field and opens the command palette: "Find a command   Ctrl+K".
class FindField : public QPushButton {
  Q_OBJECT
 public:
  explicit FindField(QAction* opens, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent*) override;
  void enterEvent(QEnterEvent*) override;

 private:
  void refresh();
  QAction* opens_;
  QLabel* keys_;
};

}  // namespace blossom::ui
