#include "ui/controls/window_keys.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace blossom::ui {
namespace {

/// The letters with Ctrl that everybody expects to mean the text.
bool isOfText(const QKeyEvent& key) {
  using enum QKeySequence::StandardKey;
  for (const auto each : {SelectAll, Copy, Cut, Paste, Undo, Redo})
    if (key.matches(each)) return true;
  return false;
}

bool isLetterWithCtrl(const QKeyEvent& key) {
  return key.modifiers() == Qt::ControlModifier && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
}

class WindowKeys final : public QObject {
 public:
  explicit WindowKeys(QLineEdit* line) : QObject(line), line_(line) { line->installEventFilter(this); }

 private:
  bool eventFilter(QObject*, QEvent* event) override {
    if (!belongsToTheWindow(*event, *line_)) return false;
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

bool belongsToTheWindow(const QEvent& event, const QLineEdit& line) {
  if (event.type() != QEvent::ShortcutOverride) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  return asksForUndo(event) ? !line.isModified() : isLetterWithCtrl(key) && !isOfText(key);
}

void leaveKeysToTheWindow(QLineEdit* line) { new WindowKeys(line); }

}  // namespace blossom::ui
