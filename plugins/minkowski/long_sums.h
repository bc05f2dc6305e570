#pragma once
#include <cstddef>
#include <functional>

#include "feature/feature_type.h"

namespace blossom::minkowski {

/// A feature type whose sums may take `mostWork` edges and crossings of arrangements.
using FeatureMaker = std::function<FeatureType(std::size_t mostWork)>;

/// Sums of up to about half a second are computed in this process, so that dragging starts none; those foreseen to take
/// more, and those that turn out to, in the worker, which has its own memory and ends at once when it is cancelled.
FeatureType inWorkerWhenLong(const FeatureMaker&);

}  // namespace blossom::minkowski
