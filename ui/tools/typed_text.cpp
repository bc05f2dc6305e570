#include "ui/tools/typed_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <algorithm>
#include <utility>

namespace blossom::ui {

void TypedText::open(const QString& present) {
  present_ = text_ = present;
  caret_ = present.size();
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
  if (moveCaret(event.key())) return true;
  switch (event.key()) {
    case Qt::Key_Backspace:
      erase(caret_ - 1);
      return true;
    case Qt::Key_Delete:
      erase(caret_);
      return true;
    default:
      break;
  }
  if (event.text().isEmpty() || !event.text().front().isPrint()) return false;
  type(event.text());
  return true;
}

/// As in every line of text, a selection is left at the side to which the key goes.
bool TypedText::moveCaret(int key) {
  const bool whole = selected_ || key == Qt::Key_Home || key == Qt::Key_End;
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Home:
      caret_ = whole ? 0 : std::max<qsizetype>(caret_ - 1, 0);
      break;
    case Qt::Key_Right:
    case Qt::Key_End:
      caret_ = whole ? text_.size() : std::min(caret_ + 1, text_.size());
      break;
    default:
      return false;
  }
  selected_ = false;
  return true;
}

void TypedText::toEnd() { moveCaret(Qt::Key_End); }

void TypedText::erase(qsizetype at) {
  if (std::exchange(selected_, false)) {
    text_.clear();
    caret_ = 0;
  } else if (at >= 0 && at < text_.size()) {
    text_.remove(at, 1);
    caret_ = at;
  }
}

void TypedText::type(const QString& more) {
  if (std::exchange(selected_, false)) {
    text_.clear();
    caret_ = 0;
  }
  text_.insert(caret_, more);
  caret_ += more.size();
}

QString TypedText::shown() const {
  constexpr QChar caret(u'|');
  return selected_ ? text_ : QString(text_).insert(caret_, caret);
}

}  // namespace blossom::ui
