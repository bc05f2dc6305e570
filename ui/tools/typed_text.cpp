#include "ui/tools/typed_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <utility>

namespace blossom::ui {

void TypedText::open(const QString& present) {
  present_ = text_ = present;
  selected_ = !present.isEmpty();
}

TypedKey TypedText::key(const QKeyEvent& event) {
  if (edit(event)) return TypedKey::Text;
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return TypedKey::Other;
  switch (event.key()) {
    case Qt::Key_Escape:
      return TypedKey::Leave;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return TypedKey::Take;
    default:
      return change(event) ? TypedKey::Text : TypedKey::Other;
  }
}

/// What every line of text answers. Undo must not reach the document while something is typed.
bool TypedText::edit(const QKeyEvent& event) {
  if (event.matches(QKeySequence::SelectAll)) {
    selected_ = !text_.isEmpty();
  } else if (event.matches(QKeySequence::Paste)) {
    type(QGuiApplication::clipboard()->text().simplified());
  } else if (event.matches(QKeySequence::Undo)) {
    open(present_);
  } else {
    return event.matches(QKeySequence::Redo);
  }
  return true;
}

bool TypedText::change(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      selected_ = false;
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      text_ = std::exchange(selected_, false) ? QString() : text_.chopped(text_.isEmpty() ? 0 : 1);
      return true;
    default:
      break;
  }
  if (event.text().isEmpty() || !event.text().front().isPrint()) return false;
  type(event.text());
  return true;
}

void TypedText::type(const QString& more) { text_ = (std::exchange(selected_, false) ? QString() : text_) + more; }

}  // namespace blossom::ui
