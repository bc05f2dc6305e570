#include "feature/plugin.h"
#include "feature_types.h"

BLOSSOM_PLUGIN(registry) {
  using namespace blossom::sweep;
  registry.addAll(sweepFeature(), pullFeature(), twistFeature(), factorsFeature());
  registry.addAll(frameFeature(), primitiveFeature(), refineFeature());
  registry.add(growthFeature());
}
