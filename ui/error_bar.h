#pragma once
#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace blossom::ui {

/// Says in place what went wrong and what to do about it; nothing waits for it to be read.
class ErrorBar : public QFrame {
  Q_OBJECT
 public:
  explicit ErrorBar(QWidget* parent = nullptr);

  void showError(const QString& message, const QString& hint);
  void showNote(const QString& message, const QString& details);
  /// A button that does something about it, e.g. "Open what is readable".
  void offer(const QString& label, std::function<void()> action);
  [[nodiscard]] QString message() const;
  [[nodiscard]] QString hint() const;

 private:
  void present(const char* kind, const QString& message, const QString& hint);
  QLabel* icon_;
  QLabel* message_;
  QLabel* hint_;
  QPushButton* action_;
  std::function<void()> act_;
};

}  // namespace blossom::ui
