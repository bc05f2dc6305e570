#include "feature/plugin.h"
#include "feature/registry.h"
#include "feature_types.h"
#include "long_sums.h"

namespace blossom::minkowski {
namespace {

void registerAll(Registry& registry) {
  for (const auto& make : {morphFeature, sumFeature, differenceFeature, openingFeature, closingFeature, outlineSweepFeature,
                           solidFeature, repeatFeature, hullFeature, comparisonFeature})
    registry.add(inWorkerWhenLong(make));
}

}  // namespace
}  // namespace blossom::minkowski

BLOSSOM_PLUGIN(registry) { blossom::minkowski::registerAll(registry); }
