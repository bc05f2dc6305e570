// The keys of a DrawTool: what is typed, its commands, and its own steps of undo.
#include <QKeyEvent>
#include <QKeySequence>

#include "manipulators/draw_tool.h"

namespace blossom::modeling {

bool DrawTool::key(const QKeyEvent& event) {
  refusal_.clear();
  const bool taken = historyKey(event) || entryKey(event) || commandKey(event);
  if (taken) emit changed();
  return taken;
}

QString DrawTool::undoText() const {
  if (draft_.entry().open()) return tr("what is typed");
  return draft_.started() ? tr("the last point") : QString();
}
QString DrawTool::redoText() const { return undone_.empty() ? QString() : tr("the last point"); }

void DrawTool::takeBack() {
  const OutlineDraft before = draft_;
  if (draft_.back()) undone_.push_back(before);
}

void DrawTool::undo() {
  refusal_.clear();
  if (draft_.entry().open()) {
    draft_.entry().clear();
  } else {
    takeBack();
  }
  emit changed();
}

// Where the mouse is now, and what is typed now, is not of the step.
void DrawTool::redo() {
  if (undone_.empty()) return;
  refusal_.clear();
  const auto hovered = draft_.hovered();
  draft_ = undone_.back();
  undone_.pop_back();
  draft_.setLengthUnit(host().lengthUnit());
  draft_.entry().clear();
  if (hovered) draft_.hover(*hovered);
  emit changed();
}

/// The keys of Undo and Redo; where there is no point to take back they are left to the document.
bool DrawTool::historyKey(const QKeyEvent& event) {
  if (event.matches(QKeySequence::Undo) && !undoText().isEmpty()) {
    undo();
    return true;
  }
  const bool again =
      event.matches(QKeySequence::Redo) || (event.key() == Qt::Key_Y && event.modifiers() == Qt::ControlModifier);
  if (!again || redoText().isEmpty()) return false;
  redo();
  return true;
}

/// Keys of a typed measure; they come first while one is open.
bool DrawTool::entryKey(const QKeyEvent& event) {
  TypedEntry& entry = draft_.entry();
  if (entry.open() && event.key() == Qt::Key_Escape) {
    entry.clear();
    return true;
  }
  if (entry.open() && event.key() == Qt::Key_Backspace) return entry.back();
  if (event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab) {
    if (draft_.from() && !draft_.wantsMiddle()) entry.switchField();
    return true;
  }
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  const QByteArray text = event.text().toLatin1();
  if (text.size() != 1) return false;
  // Digits turn the view until there is a point to measure from; "@" begins the place of the first one.
  const bool turnsView = !draft_.started() && !entry.open() && text.at(0) != '@';
  return !turnsView && entry.type(text.at(0));
}

bool DrawTool::commandKey(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  switch (event.key()) {
    case Qt::Key_L:
      draft_.choose(DrawnKind::Line);
      return true;
    case Qt::Key_A:
      draft_.choose(DrawnKind::Arc);
      return true;
    case Qt::Key_S:
      draft_.choose(DrawnKind::Spline);
      return true;
    case Qt::Key_C:
      draft_.hover({draft_.outline().start, SnapKind::Start, {}});
      if (draft_.canClose() && !draft_.wantsMiddle()) place();
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      takeBack();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (draft_.entry().open()) {
        place();
      } else {
        finish();
      }
      return true;
    default:
      return false;
  }
}

}  // namespace blossom::modeling
