#include "kernel/repetition.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "kernel/curves/curved_sum.h"

namespace blossom::minkowski {

SoundRegion Adder::operator()(const SoundRegion& a, const SoundRegion& b, const Progress& progress) {
  effort_.expect(planned_ > count_ ? planned_ - count_ : 1);
  const double all = static_cast<double>(std::max(planned_, count_ + 1)), done = static_cast<double>(count_);
  ++count_;
  return sum(a, b, progress.part(done / all, (done + 1) / all), effort_);
}

std::size_t sumsOfRepetition(bool convex, std::size_t k) {
  return convex || k == 1 ? 0 : static_cast<std::size_t>(std::bit_width(k) - 1 + std::popcount(k) - 1);
}

SoundRegion repeated(const SoundRegion& shape, std::size_t k, Adder& add, const Progress& progress) {
  if (k == 1) return shape;
  if (isConvex(shape)) return scaled(shape, static_cast<double>(k));
  std::optional<SoundRegion> result;
  SoundRegion power = shape;
  for (std::size_t rest = k;;) {
    if (rest % 2 == 1) result = result ? add(*result, power, progress) : power;
    rest /= 2;
    if (rest == 0) return *result;
    power = add(power, power, progress);
  }
}

}  // namespace blossom::minkowski
