#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom::morphology {

/// Twice the volume that a closed shell encloses by its area: how far its two sides are from each other on average, below 0
/// for a shell that is inside out, 0 for one without area. In whole numbers where doubles would not know it to one in a
/// thousand. O(n)
/// @param shell numbers of its faces @param unit of the grid on which corners are taken to lie, within 2^60 of it
double meanThickness(const Mesh&, std::span<const std::size_t> shell, double unit);

/// The same on the finest grid that holds the mesh.
double meanThickness(const Mesh&, std::span<const std::size_t> shell);
/// Of all faces of a mesh.
double meanThickness(const Mesh&);

/// The numbers of the faces of each shell.
std::vector<std::vector<std::size_t>> facesOfShells(const MeshTopology&);

}  // namespace blossom::morphology
