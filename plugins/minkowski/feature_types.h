#pragma once
#include <cstddef>

#include "feature/feature_type.h"

namespace blossom::minkowski {

// Each limits its sums to `maximumWork`, see kernel/effort.h.
FeatureType morphFeature(std::size_t maximumWork);
FeatureType sumFeature(std::size_t maximumWork);
FeatureType differenceFeature(std::size_t maximumWork);
FeatureType openingFeature(std::size_t maximumWork);
FeatureType closingFeature(std::size_t maximumWork);
FeatureType repeatFeature(std::size_t maximumWork);
FeatureType hullFeature(std::size_t maximumWork);
FeatureType outlineSweepFeature(std::size_t maximumWork);
FeatureType solidFeature(std::size_t maximumWork);
FeatureType comparisonFeature(std::size_t maximumWork);

}  // namespace blossom::minkowski
