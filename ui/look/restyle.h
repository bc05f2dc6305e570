#pragma once
class QWidget;

namespace blossom::ui {

/// Sets a property by which the style sheet chooses, such as "wrong" of a line that cannot be read, and has the widget drawn
/// accordingly.
void restyle(QWidget*, const char* property, bool on);

}  // namespace blossom::ui
