#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/sums/sampled_pair.h"

namespace blossom::minkowski {

using namespace planar;

/// Computes Minkowski sums and counts them, in several threads at once when the work is unlimited. The origin alone
/// (point_shape.h) changes no shape and takes no sum.
class Adder {
 public:
  explicit Adder(std::size_t maximumWork = Effort::unlimited) : effort_(maximumWork) {}

  SoundRegion operator()(const SoundRegion& a, const SoundRegion& b, const Progress& progress);
  /// What sums of multiples of two kept shapes have in common is computed once.
  void keep(SoundRegion&);
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Effort& effort() { return effort_; }
  /// Sets the total number of sums, for progress and for the estimate of the work that is left.
  void plan(std::size_t sums) { planned_ = sums; }

 private:
  const SampledPair* keptPair(const SoundRegion& a, const SoundRegion& b, const Progress&);

  std::size_t planned_ = 0;
  std::atomic<std::size_t> count_ = 0;
  Effort effort_;
  std::mutex mutex_;  // of the following
  std::vector<SoundRegion> kept_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, SampledPair> pairs_;  // the places of values stay
};

/// (1-t) A + t B, where 0 A is the origin alone: no sum at t = 0 and t = 1. @pre 0 <= t <= 1
SoundRegion between(const SoundRegion& a, const SoundRegion& b, double t, Adder&, const Progress&);

/// Number of sums that `repeated` needs.
std::size_t sumsOfRepetition(bool convex, std::size_t k);
/// [k]A, the sum of k copies of A: k A without a sum when A is convex, else by doubling in floor(log2 k) + popcount(k) - 1
/// sums. @pre k >= 1
SoundRegion repeated(const SoundRegion&, std::size_t k, Adder&, const Progress& = Progress::none());

}  // namespace blossom::minkowski
