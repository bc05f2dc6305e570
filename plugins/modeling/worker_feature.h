#pragma once
#include <functional>
#include <string>

#include "feature/feature_type.h"

namespace blossom::modeling {

using WorkerCondition = std::function<bool(const Value& parameters, const Inputs&)>;

/// The same feature type, evaluated in the worker process: what OCCT does there can be cancelled at once and may crash
/// without harm. `activity` completes "The helper process .. crashed"; `when` limits it to evaluations that are worth the
/// start of a process (50 to 100 ms). Takes regions, curves and B-reps; the result has name and colour of the first B-rep.
FeatureType inWorker(FeatureType, std::string activity, WorkerCondition when = {});

}  // namespace blossom::modeling
