#pragma once

class QEvent;
class QLineEdit;

namespace blossom::ui {

/// Undo and redo keys belong to the document while nothing is typed in the line: Qt's line edits keep these keys for
/// themselves, also when they have nothing to take back.
void leaveUndoToTheDocument(QLineEdit*);
/// Whether Qt asks here who wants the keys of undo or redo.
bool asksForUndo(const QEvent&);

}  // namespace blossom::ui
