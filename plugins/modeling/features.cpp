#include "features.h"

#include "feature/plugin.h"

BLOSSOM_PLUGIN(registry) { blossom::modeling::registerOutlines(registry); }
