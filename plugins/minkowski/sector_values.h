#pragma once
#include <numbers>
#include <vector>

#include "kernel/morph/sector_shape.h"
#include "parameter/value.h"

namespace blossom::minkowski {

/// Reads the parameter `sectors` of a morph, whose angles are in degrees.
inline std::vector<Sector> sectorsIn(const std::vector<Value>& values) {
  const auto radians = [](const Value& sector, const char* end) { return sector.value(end, 0.0) * std::numbers::pi / 180; };
  std::vector<Sector> sectors;
  sectors.reserve(values.size());
  for (const Value& value : values) sectors.push_back({radians(value, "from"), radians(value, "to")});
  return sectors;
}

}  // namespace blossom::minkowski
