#pragma once
#include <algorithm>
#include <cstddef>

namespace blossom::sweep {

/// The indices begin .. end - 1; empty when end <= begin.
struct GridRange {
  std::size_t begin = 0, end = 0;

  [[nodiscard]] bool empty() const { return end <= begin; }
  [[nodiscard]] std::size_t size() const { return empty() ? 0 : end - begin; }
  friend bool operator==(const GridRange&, const GridRange&) = default;
};

/// The smallest range with both.
inline GridRange hull(const GridRange& a, const GridRange& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Rows (parameters u) and columns (parameters v) of a grid.
struct GridRectangle {
  GridRange rows, columns;
  friend bool operator==(const GridRectangle&, const GridRectangle&) = default;
};

}  // namespace blossom::sweep
