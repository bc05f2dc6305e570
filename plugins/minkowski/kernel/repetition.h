#pragma once
#include <cstddef>

#include "core/progress.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// A sum that counts itself.
class Adder {
 public:
  Polygons operator()(const Polygons& a, const Polygons& b, const Progress& progress) {
    ++count_;
    return add(a, b, progress);
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  static Polygons add(const Polygons&, const Polygons&, const Progress&);
  std::size_t count_ = 0;
};

/// [k]A, A added k times: k A in no sum where A is convex, else by doubling in floor(log2 k) + popcount(k) - 1 sums.
/// @pre k >= 1
Polygons repeated(const Polygons&, std::size_t k, Adder&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
