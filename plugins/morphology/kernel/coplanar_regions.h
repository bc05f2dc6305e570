#pragma once
#include <cstddef>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom::morphology {

/// Neighbouring triangles of one plane each.
struct CoplanarRegions {
  std::vector<int> ofFace;  ///< the number of the region of each triangle
  std::size_t count = 0;
};

/// Regions grow from the largest triangles, which know their planes best, to neighbours with all corners within the
/// tolerance of that plane. O(n log n). @param tolerance mm
CoplanarRegions coplanarRegions(const Mesh& triangles, const MeshTopology&, double tolerance);

}  // namespace blossom::morphology
