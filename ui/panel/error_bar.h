#pragma once
#include <functional>

#include "ui/look/passing_bar.h"

class QHBoxLayout;
class QLabel;

namespace blossom::ui {

/// A button that helps with a problem.
struct Offer {
  QString label;  ///< of the button
  std::function<void()> go;
};

/// Shows an error with its remedy over the upper edge of the view; not modal.
class ErrorBar : public PassingBar {
  Q_OBJECT
 public:
  explicit ErrorBar(QWidget* parent = nullptr);

  void showError(const QString& message, const QString& hint);
  void showNote(const QString& message, const QString& details);
  /// Adds a button, e.g. "Open what is readable"; the first one added is leftmost.
  void offer(const QString& label, std::function<void()> action);
  /// What is shown is about the document as it is now, and hides when that changes.
  void untilChange() { untilChange_ = true; }
  void documentChanged();
  [[nodiscard]] QString message() const;
  [[nodiscard]] QString hint() const;

 signals:
  void errorShown(const QString& sentences);

 private:
  void present(const char* kind, const QString& message, const QString& hint);
  QLabel* icon_;
  QLabel* message_;
  QLabel* hint_;
  QHBoxLayout* offers_;
  bool untilChange_ = false;
};

}  // namespace blossom::ui
