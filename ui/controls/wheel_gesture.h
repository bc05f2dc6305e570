#pragma once
class QWheelEvent;
class QWidget;

namespace blossom::ui {

/// ms without a turn of the wheel after which the next turn is another gesture.
constexpr unsigned wheelPauseMs = 1000;

/// Begins to watch the wheel of the whole application; what wants to ask `wheelMeans` calls it when it is made.
void watchWheel();
/// Whether a turn of the wheel is meant for this field: the gesture began on it while it had the focus. A field that slides
/// under the pointer while something else scrolls is left alone. A gesture ends by a pause, by the pointer being moved, by a
/// click, or when the focus goes elsewhere.
bool wheelMeans(const QWidget& field);

}  // namespace blossom::ui
