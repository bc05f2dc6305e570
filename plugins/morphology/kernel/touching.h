#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Every vertex of a shell with the position of an earlier one; two parts of the shell touch there.
std::vector<int> touchingVertices(const Mesh& shell);

/// A shell whose touching parts were separated, and tetrahedra in which the two shells differ: points in an odd number of
/// them are inside one and outside the other.
struct PulledApart {
  Mesh shell;
  std::vector<std::array<Vec3, 4>> between;
};

/// Separates the parts of an outward shell of closed triangles that touches itself only in common vertices and edges and has
/// no intersections. Moves are tried until the exact test finds no touching parts; empty when none succeeds. O(n log n) per
/// try.
std::optional<PulledApart> pulledApart(const Mesh& shell, const Progress&);

}  // namespace blossom::morphology
