#pragma once
#include <QSize>

namespace blossom::ui {

/// How large the window comes up where nobody asked for a size: with its frame it fits the room that the desktop leaves.
[[nodiscard]] QSize firstSize(const QSize& available);

}  // namespace blossom::ui
