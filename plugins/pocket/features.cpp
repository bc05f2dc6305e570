#include "feature/plugin.h"
#include "feature_groups.h"

BLOSSOM_PLUGIN(registry) {
  blossom::pocket::registerOffsetFeatures(registry);
  blossom::pocket::registerPocketFeatures(registry);
}
