#include "geometry/planar/winding/cell_borders.h"

#include <cmath>
#include <cstddef>

namespace blossom::planar {

CellBorders::CellBorders(std::int64_t low, std::int64_t high, std::int64_t size) : twiceLow_(2 * low - 1) {
  const std::int64_t width = high - low + 1;
  for (std::int64_t k = 0; k <= (width + size - 1) / size; ++k) at_.push_back(static_cast<double>(k * size));
  index();
}

void CellBorders::index() {
  const auto count = static_cast<std::size_t>(cells());
  bucketsPerUnit_ = static_cast<double>(count) / at_.back();
  firstOf_.assign(count, 0);
  std::size_t cell = 0;
  for (std::size_t bucket = 0; bucket < count; ++bucket) {
    while (cell + 1 < count && at_[cell + 1] * bucketsPerUnit_ <= static_cast<double>(bucket)) ++cell;
    firstOf_[bucket] = static_cast<int>(cell);
  }
}

void CellBorders::refine(std::span<const std::int64_t> places, std::int64_t smallest) {
  constexpr std::size_t few = 32, crowded = 6, growth = 3;  // crowded: times the mean
  std::vector<double> sorted;
  sorted.reserve(places.size());
  for (const std::int64_t place : places) sorted.push_back(fromFirst(place));
  const std::size_t mean = std::max(few, sorted.size() / static_cast<std::size_t>(cells()));
  {
    std::vector<std::size_t> held(static_cast<std::size_t>(cells()), 0);
    for (const double place : sorted) ++held[static_cast<std::size_t>(cellAt(place))];
    if (*std::max_element(held.begin(), held.end()) <= crowded * mean) return;
  }
  std::sort(sorted.begin(), sorted.end());
  std::size_t left = (growth - 1) * static_cast<std::size_t>(cells()) + few;  // cells that may be added
  std::vector<double> borders{0};
  std::vector<double> ends(at_.rbegin(), at_.rend() - 1);  // of the cells to come, the next one last
  auto first = sorted.begin();
  while (!ends.empty()) {
    const auto last = std::lower_bound(first, sorted.end(), ends.back());
    const double middle = std::floor((borders.back() + ends.back()) / 2);
    if (static_cast<std::size_t>(last - first) > mean && left > 0 &&
        ends.back() - borders.back() >= 2 * static_cast<double>(smallest)) {
      ends.push_back(middle);
      --left;
      continue;
    }
    borders.push_back(ends.back());
    ends.pop_back();
    first = last;
  }
  at_ = std::move(borders);
  index();
}

}  // namespace blossom::planar
