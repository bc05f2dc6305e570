#pragma once
#include <QSize>

namespace blossom::ui {

/// The size of the window when no size was requested: with its frame it fits into the available area of the desktop.
[[nodiscard]] QSize firstSize(const QSize& available);

}  // namespace blossom::ui
