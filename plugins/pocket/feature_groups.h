#pragma once
// Not named features.h: the C library has a header of that name, which the plugin's include folder would hide.
#include "feature/registry.h"

namespace blossom::pocket {

/// Each registers the feature types of one group.
void registerOffsetFeatures(Registry&);  ///< offset, medial axis

}  // namespace blossom::pocket
