#include "feature_types.h"

#include "feature/plugin.h"

BLOSSOM_PLUGIN(registry) {
  registry.add(blossom::subdivision::subdivideFeature());
  registry.add(blossom::subdivision::deformFeature());
  registry.add(blossom::subdivision::strokeFeature());
}
