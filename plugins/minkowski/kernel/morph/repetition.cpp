#include "kernel/morph/repetition.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "geometry/planar/sums/curved_sum.h"
#include "kernel/morph/point_shape.h"

namespace blossom::minkowski {

using namespace planar;

SoundRegion Adder::operator()(const SoundRegion& a, const SoundRegion& b, const Progress& progress) {
  if (isOrigin(a)) return b;
  if (isOrigin(b)) return a;
  const std::size_t before = count_++;
  if (effort_.isLimited()) effort_.expect(planned_ > before ? planned_ - before : 1);
  const double all = static_cast<double>(std::max(planned_, before + 1)), done = static_cast<double>(before);
  const Progress part = progress.part(done / all, (done + 1) / all);
  const SampledPair* kept = keptPair(a, b, part);
  if (!kept) return sum(a, b, part, effort_);
  const SampledPair multiples = scaled(*kept, a.factor, b.factor);
  return sum(a, b, multiples, part, effort_);
}

void Adder::keep(SoundRegion& shape) {
  shape.factor = 1;
  const std::scoped_lock lock(mutex_);
  kept_.push_back(shape);
  shape.kept = static_cast<std::uint32_t>(kept_.size());
}

/// Nothing where a shape is not kept, or where no curves are sampled.
const SampledPair* Adder::keptPair(const SoundRegion& a, const SoundRegion& b, const Progress& progress) {
  if (a.kept == 0 || b.kept == 0 || !(hasCurves(a.region) || hasCurves(b.region))) return nullptr;
  const std::scoped_lock lock(mutex_);
  const auto [place, isNew] = pairs_.try_emplace({a.kept, b.kept});
  if (isNew) {
    place->second = sampledPair(kept_[a.kept - 1], kept_[b.kept - 1], 1, Sampling::Chords, progress);
    certifyClear(place->second, progress);
  }
  return &place->second;
}

SoundRegion between(const SoundRegion& a, const SoundRegion& b, double t, Adder& add, const Progress& progress) {
  if (t == 0) return a;
  if (t == 1) return b;
  return add(scaled(a, 1 - t), scaled(b, t), progress);
}

std::size_t sumsOfRepetition(bool convex, std::size_t k) {
  return convex || k == 1 ? 0 : static_cast<std::size_t>(std::bit_width(k) - 1 + std::popcount(k) - 1);
}

SoundRegion repeated(const SoundRegion& shape, std::size_t k, Adder& add, const Progress& progress) {
  if (k == 1) return shape;
  if (repeatsAsMultiple(shape)) return scaled(shape, static_cast<double>(k));
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
