#pragma once
#include "feature/feature_type.h"

namespace blossom::sweep {

FeatureType sweepFeature();
FeatureType pullFeature();
FeatureType twistFeature();

}  // namespace blossom::sweep
