#include "ui/look/passing_bar.h"

namespace blossom::ui {

void PassingBar::setVisible(bool visible) {
  if (!visible) freeFocusOf(this);
  QFrame::setVisible(visible);
}

// The window's own memory of it counts, too: while a dialog is open, nothing in the window has the focus.
void PassingBar::freeFocusOf(const QWidget* going) {
  const QWidget* const focused = window()->focusWidget();
  if (focused && (focused == going || going->isAncestorOf(focused))) emit focusFreed();
}

}  // namespace blossom::ui
