#pragma once
#include <vector>

#include "geometry/planar/region.h"
#include "parameter/value.h"

namespace blossom {

/// Paths as JSON, with their layers and colours.
Value pathsValue(const std::vector<Path>&);
std::vector<Path> toPaths(const Value&);

}  // namespace blossom
