#pragma once
#include <string>
#include <utility>

#include "isolate/isolated.h"

namespace blossom::modeling {

/// `isolated` in the worker that loads this plugin.
FeatureType inWorker(FeatureType, std::string activity,
                     std::function<bool(const Value& parameters, const Inputs&)> when = {});

}  // namespace blossom::modeling
