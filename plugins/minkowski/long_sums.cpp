#include "long_sums.h"

#include "isolate/in_worker.h"
#include "kernel/effort.h"

namespace blossom::minkowski {

namespace {

constexpr std::size_t workOfHalfASecond = 40'000'000;

}  // namespace

FeatureType inWorkerWhenLong(const FeatureMaker& make) {
  FeatureType type = inWorker(make(Effort::unlimited), {.activity = "for the Minkowski sums"});
  type.evaluate = [here = make(workOfHalfASecond).evaluate, apart = type.evaluate](
                      const Value& parameters, const Inputs& inputs, const Progress& progress) {
    try {
      return here(parameters, inputs, progress);
    } catch (const TooMuchWork&) {
      return apart(parameters, inputs, progress);
    }
  };
  return type;
}

}  // namespace blossom::minkowski
