#pragma once
#include <QString>

class QKeyEvent;

namespace blossom::ui {

/// What is typed in the view: it begins with the present text, selected, so that the first key takes its place; an arrow
/// key, Home or End keeps it to be added to.
class TypedText {
 public:
  void open(const QString& present);
  /// Of a printable character, Backspace and the keys that leave the selection. @returns whether it was one of these.
  bool key(const QKeyEvent&);

  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] bool selected() const { return selected_; }
  /// It would leave everything as it is.
  [[nodiscard]] bool unchanged() const { return text_.trimmed().isEmpty() || text_ == present_; }

 private:
  QString present_, text_;
  bool selected_ = false;
};

}  // namespace blossom::ui
