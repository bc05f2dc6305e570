#pragma once
// Not named features.h: the C library has a header of that name, which the plugin's include folder would hide.
#include "feature/registry.h"
#include "kernel/offset/clearance_diagram.h"

namespace blossom::pocket {

/// Each registers the feature types of one group.
void registerOffsetFeatures(Registry&);  ///< offset, medial axis
void registerPocketFeatures(Registry&);  ///< setup, pocket, simulate, carve

FeatureType medialAxisFeature();
FeatureType simulateFeature();
FeatureType setupFeature();
FeatureType carveFeature();

/// Adds the statistics of the diagram to `stats`.
void addDiagramStats(const ClearanceDiagram&, Value& stats);

}  // namespace blossom::pocket
