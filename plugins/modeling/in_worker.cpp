#include "in_worker.h"

#include "worker/worker.h"

namespace blossom::modeling {

namespace {

/// Its address identifies this module.
const char anchor = 0;

}  // namespace

FeatureType inWorker(FeatureType type, std::string activity,
                     std::function<bool(const Value& parameters, const Inputs&)> when) {
  return isolated(std::move(type), {.activity = std::move(activity), .module = moduleOf(&anchor), .when = std::move(when)});
}

}  // namespace blossom::modeling
