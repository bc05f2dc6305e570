#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/place.h"

namespace blossom::morphology {

struct CheckedSolid {
  Mesh triangles;  ///< closed, oriented outward, no triangle of zero area, no intersections
  std::vector<std::string> warnings;
  std::optional<Vec3> bodyInBody = std::nullopt;  ///< where a body lies within another one
  bool isLess = false;                            ///< bodies or voids thinner than the step of the grid are left out
  bool shellsMeet = false;                        ///< they overlap or touch
  double wallsWithin = 0;  ///< mm between faces in which bodies touch but for rounding; 0: they do not
};

/// A mesh as the boundary of a solid. Defects with an unambiguous repair are repaired (all faces oriented inward, triangles
/// of zero area, overlapping bodies); others are refused with their place.
/// @param step of the grid on which the mesh lies: a body that is thinner on average is left out, as rounding may have
/// turned it inside out; 0: none
/// @throws Error InvalidInput for an empty, open, non-manifold, twisted or self-intersecting mesh and for coordinates that
/// are not finite; LimitExceeded for coordinates beyond 1e9 mm.
CheckedSolid checkedSolid(const Mesh&, double step, const Subject& subject, const Progress& = Progress::none());

/// Whether each edge has as many faces one way round as the other, once corners at equal places are one.
bool isClosed(const Mesh&, const Progress&);

/// The checks that need no exact arithmetic: finite numbers, indices, size. @throws Error.
void refuseUnusable(const Mesh&, const Subject& subject);

}  // namespace blossom::morphology
