#pragma once
#include <cstddef>
#include <vector>

#include "kernel/morph/control_placement.h"
#include "parameter/value.h"

namespace blossom::minkowski {

/// Where the parameters of a morph, complete and canonical, put its control shapes; as many as there are.
std::vector<Placement> placementsIn(const Value& parameters, std::size_t shapes);

/// Writes placements into such parameters; what stands at the end of a list and says nothing is left out.
void writePlacements(Value& parameters, const std::vector<Placement>&);

}  // namespace blossom::minkowski
