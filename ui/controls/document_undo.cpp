#include "ui/controls/document_undo.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace blossom::ui {
namespace {

class UndoFilter final : public QObject {
 public:
  explicit UndoFilter(QLineEdit* line) : QObject(line), line_(line) { line->installEventFilter(this); }

 private:
  bool eventFilter(QObject*, QEvent* event) override {
    if (line_->isModified() || !asksForUndo(*event)) return false;
    event->ignore();  // so the key goes on to the window's shortcuts
    return true;
  }

  QLineEdit* line_;
};

}  // namespace

bool asksForUndo(const QEvent& event) {
  if (event.type() != QEvent::ShortcutOverride) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

void leaveUndoToTheDocument(QLineEdit* line) { new UndoFilter(line); }

}  // namespace blossom::ui
