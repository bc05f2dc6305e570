#pragma once
#include "feature/feature_type.h"

namespace blossom::sweep {

FeatureType sweepFeature();

// Edits of a motion.
FeatureType pullFeature();
FeatureType twistFeature();
FeatureType factorsFeature();

// How a motion begins.
FeatureType frameFeature();
FeatureType primitiveFeature();
FeatureType refineFeature();

/// The way through the edits, as a sequence.
FeatureType growthFeature();

}  // namespace blossom::sweep
