#pragma once
#include <QString>
#include <Qt>
#include <vector>

namespace blossom::ui {

/// Which buttons turn, shift and zoom the view: as people know it from other programs.
enum class NavigationStyle { Blossom, FreeCad, Rhino, Fusion };

/// By the value of the preference "navigation": "blossom", "freecad", "rhino", "fusion".
NavigationStyle navigationStyle(const QString& name);

enum class DragAction { None, Orbit, Pan, Zoom, Box };

struct DragBinding {
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
  DragAction action;
};

/// The table of a style. What is not in it does nothing.
const std::vector<DragBinding>& dragBindings(NavigationStyle);
DragAction dragAction(NavigationStyle, Qt::MouseButtons, Qt::KeyboardModifiers);

/// The table in words, for the status line: "Click: select · Drag: orbit · ..".
QString navigationHint(NavigationStyle);

}  // namespace blossom::ui
