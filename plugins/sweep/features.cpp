#include "feature/plugin.h"
#include "feature_types.h"

BLOSSOM_PLUGIN(registry) {
  registry.add(blossom::sweep::sweepFeature());
  registry.add(blossom::sweep::pullFeature());
  registry.add(blossom::sweep::twistFeature());
}
