#include "feature/plugin.h"
BLOSSOM_PLUGIN(registry) { (void)registry; }
