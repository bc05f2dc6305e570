#pragma once
#include <cstddef>
#include <numeric>
#include <vector>

namespace blossom::sweep {

/// Mean of the knots inside the support of a pole: near it the pole has the most influence.
inline double greville(int degree, const std::vector<double>& knots, std::size_t pole) {
  const auto from = knots.begin() + static_cast<std::ptrdiff_t>(pole) + 1;
  return std::accumulate(from, from + degree, 0.0) / degree;
}

}  // namespace blossom::sweep
