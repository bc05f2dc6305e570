#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The corners of a + b for convex polyhedra: pairs of a corner of each whose cones of outward normals overlap, found by
/// walking along the edges of either through the cones of the other (the overlay of their Gauss maps). About O((n + m + k)
/// log k) for k pairs, where all pairs are n m. Cones that overlap by less than about 2e-11 radians are left out, so that of
/// parallel faces only the corners of their sum count: the hull of the pairs lacks at most that angle times the length of an
/// edge.
/// @pre closed triangles, counter-clockwise seen from outside. @throws Error Cancelled
std::vector<std::array<int, 2>> cornersOfSum(const Mesh& a, const Mesh& b, const Progress& = Progress::none());

/// The corners of weightA a + weightB b, which are the same pairs for all weights above 0.
std::vector<Vec3> pointsOfSum(const Mesh& a, double weightA, const Mesh& b, double weightB,
                              std::span<const std::array<int, 2>> corners);

}  // namespace blossom::morphology
