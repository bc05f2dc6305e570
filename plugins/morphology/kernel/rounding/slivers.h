#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom::morphology {

/// Closed faces without the shells whose two sides are nearer to each other than a thickness above 0, on average over
/// their area: rounding may have turned them inside out. Nothing where all shells are thicker; no faces where none is. O(n
/// log n).
/// @param unit of the grid on which corners are taken to lie
std::optional<Mesh> withoutSlivers(const Mesh&, const MeshTopology&, double thickness, double unit, const Progress&);

}  // namespace blossom::morphology
