#pragma once

namespace blossom::ui {

/// Parts of the window that follow the document, its results and the selection. Handles: what tools and measurements draw
/// over the shapes. Actors: shapes of single features that are sent to the graphics card anew.
enum class WindowPart { View, Handles, Actors, Tree, Panel, Tabs, Actions, StartPage };

/// Adds one to the count of a part, whenever it is brought up to date. Only in the window's thread.
void countRefresh(WindowPart);
/// How often the part was brought up to date since the program began. Tests compare it with event turns and pictures.
int refreshes(WindowPart);

}  // namespace blossom::ui
