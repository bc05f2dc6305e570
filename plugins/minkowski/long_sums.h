#pragma once
#include <cstddef>
#include <functional>

#include "feature/feature_type.h"

namespace blossom::minkowski {

/// Makes a feature type whose sums are limited to `maximumWork`, see effort.h.
using FeatureMaker = std::function<FeatureType(std::size_t maximumWork)>;

/// Computes sums of up to about half a second in this process, so that dragging starts no process; longer ones, whether
/// estimated beforehand or detected, in the worker, which has its own memory and ends at once when cancelled.
FeatureType inWorkerWhenLong(const FeatureMaker&);

}  // namespace blossom::minkowski
