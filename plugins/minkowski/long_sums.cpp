#include "long_sums.h"

#include "isolate/in_worker.h"
#include "kernel/effort.h"

namespace blossom::minkowski {

namespace {

constexpr std::size_t workOfHalfASecond = 40'000;

void dress(Region& made, const Region& drawn) {
  if (made.loops.size() != drawn.loops.size()) return;
  for (std::size_t i = 0; i < made.loops.size(); ++i) {
    made.loops[i].layer = drawn.loops[i].layer;
    made.loops[i].color = drawn.loops[i].color;
  }
}

/// Layers and colours stay behind on the way to the worker; the ends of a sequence are the shapes drawn and have them.
Shape withDressedEnds(const Shape& made, const Inputs& inputs) {
  const Sequence* sequence = made.get<Sequence>();
  if (!sequence) return made;
  Sequence dressed = *sequence;
  for (std::size_t k = 0; k < dressed.frames.size(); ++k) {
    if (dressed.times[k] != 0 && dressed.times[k] != 1) continue;
    const Shape& end = dressed.times[k] == 0 ? inputs.of(0).front() : inputs.of(0).back();
    const Region *frame = dressed.frames[k].get<Region>(), *drawn = end.get<Region>();
    if (!frame || !drawn) continue;
    Region region = *frame;
    dress(region, *drawn);
    dressed.frames[k] = std::move(region);
  }
  return dressed;
}

}  // namespace

FeatureType inWorkerWhenLong(const FeatureMaker& make) {
  FeatureType type = inWorker(make(Effort::unlimited), {.activity = "for the Minkowski sums"});
  type.evaluate = [here = make(workOfHalfASecond).evaluate, apart = type.evaluate](
                      const Value& parameters, const Inputs& inputs, const Progress& progress) {
    try {
      return here(parameters, inputs, progress);
    } catch (const TooMuchWork&) {
      Evaluated made = apart(parameters, inputs, progress);
      made.shape = withDressedEnds(made.shape, inputs);
      return made;
    }
  };
  return type;
}

}  // namespace blossom::minkowski
