#include "feature/plugin.h"
#include "feature_groups.h"
#include "worker/worker.h"

namespace {

void registerAll(blossom::Registry& registry) {
  blossom::modeling::registerOutlines(registry);
  blossom::modeling::registerPrimitives(registry);
  blossom::modeling::registerProfileFeatures(registry);
  blossom::modeling::registerSolidFeatures(registry);
  blossom::modeling::registerArrangements(registry);
}

}  // namespace

BLOSSOM_PLUGIN(registry) { registerAll(registry); }

/// Feature types that run in the worker register their calls when they are made.
BLOSSOM_WORKER_CALLS() {
  blossom::Registry registry;
  registerAll(registry);
}
