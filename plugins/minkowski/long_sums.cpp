#include "long_sums.h"

#include "geometry/planar/polygons/effort.h"
#include "isolate/in_worker.h"

namespace blossom::minkowski {

using namespace planar;

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
