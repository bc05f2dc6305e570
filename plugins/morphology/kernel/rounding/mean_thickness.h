#pragma once
#include <cstddef>
#include <span>

#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Twice the volume that a closed shell encloses by its area: how far its two sides are from each other on average, below 0
/// for a shell that is inside out, 0 for one without area. In whole numbers where doubles would not know it to one in a
/// thousand. O(n)
/// @param shell numbers of its faces @param unit of the grid on which corners are taken to lie, within 2^60 of it
double meanThickness(const Mesh&, std::span<const std::size_t> shell, double unit);

/// Of all faces of a mesh, on the finest grid that holds it.
double meanThickness(const Mesh&);

}  // namespace blossom::morphology
