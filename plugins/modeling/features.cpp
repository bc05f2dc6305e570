#include "feature_groups.h"

#include "feature/plugin.h"

BLOSSOM_PLUGIN(registry) { blossom::modeling::registerOutlines(registry); }
