#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Every vertex of a shell that lies in one place with an earlier one: there two parts of the shell touch.
std::vector<int> touchingVertices(const Mesh& shell);

/// A shell whose touching parts have been moved apart, and tetrahedra in which the two differ: what lies in an odd number of
/// them changes sides.
struct PulledApart {
  Mesh shell;
  std::vector<std::array<Vec3, 4>> between;
};

/// Of one shell of closed triangles that looks outwards, crosses nowhere and touches itself in common vertices and edges
/// only. Moves are tried until the exact test finds the shell free of touches; nothing when none does. O(n log n) a try.
std::optional<PulledApart> pulledApart(const Mesh& shell, const Progress&);

}  // namespace blossom::morphology
