#pragma once
#include <cstddef>
#include <variant>

#include "geometry/planar/region.h"

namespace blossom::test {

inline std::size_t segmentCount(const Region& region) {
  std::size_t count = 0;
  for (const Path& loop : region.loops) count += loop.segments.size();
  return count;
}

/// Of one kind: segmentCountOf<Arc2>(region).
template <class Kind>
std::size_t segmentCountOf(const Region& region) {
  std::size_t count = 0;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) count += std::holds_alternative<Kind>(segment) ? 1 : 0;
  return count;
}

}  // namespace blossom::test
