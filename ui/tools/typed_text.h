#pragma once
#include <QString>

class QKeyEvent;

namespace blossom::ui {

/// What a key is to a text that is typed in the view.
enum class TypedKey {
  Other,  ///< not for the text
  Text,   ///< it has changed the text, or left its selection
  Take,   ///< the text is ready: Enter
  Leave,  ///< everything is to stay as it is: Esc
};

/// What is typed in the view: it begins with the present text, selected, so that the first key takes its place; an arrow
/// key, Home or End keeps it to be added to.
class TypedText {
 public:
  void open(const QString& present);
  /// Takes printable characters, Backspace, the keys that leave the selection, and those that select all, paste, and bring
  /// the present text back (undo); no others with Ctrl, Alt or Meta.
  TypedKey key(const QKeyEvent&);
  /// As if it were typed.
  void type(const QString&);

  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] bool selected() const { return selected_; }
  /// It would leave everything as it is.
  [[nodiscard]] bool unchanged() const { return text_.trimmed().isEmpty() || text_ == present_; }

 private:
  bool edit(const QKeyEvent&);
  bool change(const QKeyEvent&);

  QString present_, text_;
  bool selected_ = false;
};

}  // namespace blossom::ui
