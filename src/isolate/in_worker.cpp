#include "isolate/in_worker.h"

#include <utility>

#include "worker/worker.h"

namespace blossom {

FeatureType inWorker(FeatureType type, IsolationOptions options, const void* insideModule) {
  options.module = moduleOf(insideModule);
  return isolated(std::move(type), std::move(options));
}

}  // namespace blossom
