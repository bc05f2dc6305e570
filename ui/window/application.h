#pragma once

namespace blossom::ui {

/// What must be set before QApplication is made: OpenGL 3.2 core and sharing of contexts.
void prepareApplication();
/// What must be set after: names, number format, style. Figures are read and written with a point whatever the user's locale
/// says.
void setUpApplication();

}  // namespace blossom::ui
