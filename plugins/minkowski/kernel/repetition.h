#pragma once
#include <cstddef>

#include "core/progress.h"
#include "kernel/effort.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// A sum that counts itself.
class Adder {
 public:
  explicit Adder(std::size_t mostWork = Effort::unlimited) : effort_(mostWork) {}

  Polygons operator()(const Polygons& a, const Polygons& b, const Progress& progress);
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Effort& effort() { return effort_; }
  /// How many sums there will be: what one of them costs is foreseen for all that are left, and the bar knows how far it is.
  void plan(std::size_t sums) { planned_ = sums; }

 private:
  std::size_t planned_ = 0, count_ = 0;
  Effort effort_;
};

/// How many sums `repeated` takes.
std::size_t sumsOfRepetition(bool convex, std::size_t k);
/// [k]A, A added k times: k A in no sum where A is convex, else by doubling in floor(log2 k) + popcount(k) - 1 sums.
/// @pre k >= 1
Polygons repeated(const Polygons&, std::size_t k, Adder&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
