#pragma once
#include <array>
#include <span>
#include <vector>

#include "geometry/bspline/surface.h"

namespace blossom::sweep {

/// Points of a rational surface over a grid of parameters; entry (k, l) of each coordinate has index k * vs.size() + l.
std::array<std::vector<double>, 3> evaluateGrid(const Surface&, std::span<const double> us, std::span<const double> vs);

}  // namespace blossom::sweep
