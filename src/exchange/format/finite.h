#pragma once
#include "geometry/planar/region.h"

namespace blossom {

/// Whether all coordinates of a path are finite, which every reader has to guarantee.
bool allFinite(const Path&);

}  // namespace blossom
