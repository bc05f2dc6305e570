#include "ui/window/first_size.h"

namespace blossom::ui {

namespace {

constexpr QSize wantedSize(1440, 900);
constexpr QSize frameSize(4, 40);  // nobody tells before the window is there: borders, and a title bar

}  // namespace

QSize firstSize(const QSize& available) { return wantedSize.boundedTo(available - frameSize); }

}  // namespace blossom::ui
