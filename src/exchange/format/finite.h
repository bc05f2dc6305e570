#pragma once
#include "geometry/planar/region.h"

namespace blossom {

/// Whether every coordinate of a path is a number; what a reader owes to all who use its curves.
bool allFinite(const Path&);

}  // namespace blossom
