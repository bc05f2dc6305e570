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
/// key, Home or End keeps it to be changed at the caret.
class TypedText {
 public:
  void open(const QString& present);
  /// Takes printable characters, Backspace, Delete, the keys that move the caret, and those that select all, paste, and
  /// bring the present text back (undo); no others with Ctrl, Alt or Meta.
  TypedKey key(const QKeyEvent&);
  /// As if it were typed.
  void type(const QString&);
  /// Moves the caret to the end; the selection is left.
  void toEnd();

  [[nodiscard]] const QString& text() const { return text_; }
  /// The text as it is drawn: with its caret, unless it is selected.
  [[nodiscard]] QString shown() const;
  [[nodiscard]] bool selected() const { return selected_; }
  /// It would leave everything as it is.
  [[nodiscard]] bool unchanged() const { return text_.trimmed().isEmpty() || text_ == present_; }

 private:
  bool edit(const QKeyEvent&);
  bool change(const QKeyEvent&);
  bool moveCaret(int key);
  /// Removes one character at an index, or the selection.
  void erase(qsizetype at);

  QString present_, text_;
  qsizetype caret_ = 0;  ///< the index before which the next character comes
  bool selected_ = false;
};

}  // namespace blossom::ui
