#pragma once
#include <vector>

#include "core/vector.h"

/// Inside of crossSection.
namespace blossom {

/// From one numbered place to another.
struct SectionSide {
  int from = -1, to = -1;
};

/// Leaves out sides that another one goes back along. O(n log n)
void cancelOpposite(std::vector<SectionSide>&);

/// The places along a closed polygon.
using SectionLoop = std::vector<int>;

/// Joins sides at their ends to loops. What does not close goes on at the nearest beginning of another open chain, or of
/// itself. O(sides + m^2) for m open chains, or O(sides) where m is above a thousand: then each is closed by itself.
std::vector<SectionLoop> chained(const std::vector<SectionSide>&, const std::vector<Vec3>& places);

}  // namespace blossom
