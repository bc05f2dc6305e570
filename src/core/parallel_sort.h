#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/parallel.h"

namespace blossom {

/// Sorts quarters at the same time, whatever the number of cores, and merges them, so that the order of equal items depends
/// on nothing else. O(n log n). @throws Error Cancelled
template <class T, class Before>
void sortInQuarters(std::vector<T>& items, const Before& before, const Progress& progress) {
  constexpr std::size_t quarters = 4;
  const auto border = [&](std::size_t i) {
    return items.begin() + static_cast<std::ptrdiff_t>(items.size() * i / quarters);
  };
  parallelFor(quarters, 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::size_t compared = 0;
      std::sort(border(i), border(i + 1), [&](const T& a, const T& b) {
        if (++compared % 65536 == 0) progress.check();
        return before(a, b);
      });
    }
  });
  parallelFor(2, 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      std::inplace_merge(border(2 * i), border(2 * i + 1), border(2 * i + 2), before);
  });
  progress.check();
  std::inplace_merge(border(0), border(2), border(4), before);
}

}  // namespace blossom
