#include "feature/plugin.h"
#include "feature_groups.h"

BLOSSOM_PLUGIN(registry) {
  blossom::modeling::registerOutlines(registry);
  blossom::modeling::registerPrimitives(registry);
  blossom::modeling::registerProfileFeatures(registry);
  blossom::modeling::registerSolidFeatures(registry);
  blossom::modeling::registerArrangements(registry);
  blossom::modeling::registerSequenceFeatures(registry);
}
