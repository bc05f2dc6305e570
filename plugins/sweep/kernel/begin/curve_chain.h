#pragma once
#include <span>
#include <vector>

#include "geometry/bspline/curve.h"

namespace blossom::sweep {

/// Curves that follow each other, as one curve of the highest of their degrees over 0..1: each is elevated, its weights
/// are multiplied so that they meet, and its share of the parameter is that of the length of its poles' polygon. At the
/// joints the knots have the multiplicity of the degree. Points stay the same, except that ends up to `gap` mm apart are
/// made to meet, those of the whole as well.
/// @throws Error InvalidInput when two ends lie farther apart, with the place. O(poles).
Curve chained(std::span<const Curve> parts, double gap);

/// The same curve from its end to its start, over the same range of the parameter.
Curve turnedRound(const Curve&);

/// The same curves so that each begins at the end that lies nearest to that of the one before, turned round where needed.
/// They begin with one that has a free end, more than `gap` mm from all others, of several with the one from which the way
/// goes on most nearly; without any, with the first one. O(n^2) for n parts.
std::vector<Curve> inOrder(std::vector<Curve> parts, double gap);

}  // namespace blossom::sweep
