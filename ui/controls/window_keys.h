#pragma once

class QEvent;
class QLineEdit;

namespace blossom::ui {

/// Keys that Qt's line edits keep for themselves go to the window: those of undo and redo while nothing is typed in the
/// line, and letters with Ctrl that only edit text on some systems, such as Ctrl+E for the end of the line.
void leaveKeysToTheWindow(QLineEdit*);
/// Whether Qt asks the line for such a key.
bool belongsToTheWindow(const QEvent&, const QLineEdit& line);
/// Whether Qt asks here who wants the keys of undo or redo.
bool asksForUndo(const QEvent&);

}  // namespace blossom::ui
