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
    if (event->type() != QEvent::ShortcutOverride || line_->isModified()) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
    event->ignore();  // so the key goes on to the window's shortcuts
    return true;
  }

  QLineEdit* line_;
};

}  // namespace

void leaveUndoToTheDocument(QLineEdit* line) { new UndoFilter(line); }

}  // namespace blossom::ui
