#include "feature/plugin.h"
#include "feature_groups.h"

BLOSSOM_PLUGIN(registry) {
  blossom::morphology::registerBall(registry);
  blossom::morphology::registerSums(registry);
  blossom::morphology::registerMorph(registry);
  blossom::morphology::registerGrowth(registry);
}
