#include "ui/thread/refreshes.h"

#include <array>
#include <cstddef>

namespace blossom::ui {

namespace {

int& countOf(WindowPart part) {
  static std::array<int, static_cast<std::size_t>(WindowPart::StartPage) + 1> counts{};
  return counts.at(static_cast<std::size_t>(part));
}

}  // namespace

void countRefresh(WindowPart part) { ++countOf(part); }
int refreshes(WindowPart part) { return countOf(part); }

}  // namespace blossom::ui
