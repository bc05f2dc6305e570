#pragma once
#include "feature/registry.h"

namespace blossom::modeling {

/// Each registers the feature types of one group.
void registerOutlines(Registry&);

}  // namespace blossom::modeling
