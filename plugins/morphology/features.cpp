#include "feature/plugin.h"
#include "feature_groups.h"
#include "worker/worker.h"

namespace {

void registerAll(blossom::Registry& registry) {
  blossom::morphology::registerBall(registry);
  blossom::morphology::registerSums(registry);
  blossom::morphology::registerMorph(registry);
  blossom::morphology::registerGrowth(registry);
}

}  // namespace

BLOSSOM_PLUGIN(registry) { registerAll(registry); }

/// Exact arithmetic cannot poll: all operations run in the worker, and register their calls when they are made.
BLOSSOM_WORKER_CALLS() {
  blossom::Registry registry;
  registerAll(registry);
}
