#pragma once
#include "feature/registry.h"

namespace blossom::sweep {

FeatureType frameFeature();
FeatureType primitiveFeature();
FeatureType refineFeature();

/// The feature types by which a motion begins.
inline void registerMotionFeatures(Registry& registry) {
  registry.addAll(frameFeature(), primitiveFeature(), refineFeature());
}

}  // namespace blossom::sweep
