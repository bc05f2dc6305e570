#pragma once

class QLineEdit;
class QWidget;

namespace blossom::ui {

/// Lets the lines in a panel rest after Enter, which takes over what was typed there: the focus stays, so that Tab and undo
/// go on from the line, but nothing more is awaited. A line rests until it is typed or clicked in again, or left. One whose
/// text was refused does not rest.
void restAfterEnter(QWidget* panel);
/// Whether the keys may go to what the mouse points at.
[[nodiscard]] bool rests(const QLineEdit&);

}  // namespace blossom::ui
