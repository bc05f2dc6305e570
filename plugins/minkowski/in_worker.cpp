#include "in_worker.h"

#include "isolate/isolated.h"
#include "kernel/effort.h"
#include "worker/worker.h"

namespace blossom::minkowski {

namespace {

/// Its address identifies this module.
const char anchor = 0;

constexpr std::size_t workOfHalfASecond = 40'000;

}  // namespace

FeatureType inWorkerWhenLong(const FeatureMaker& make) {
  FeatureType type = isolated(make(Effort::unlimited), {.activity = "for the Minkowski sums", .module = moduleOf(&anchor)});
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
