#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// The same closed triangles, of which no corner comes nearer than `least` to an edge or a face that it is no corner of, or
/// to another corner, and no edge to another edge: what is nearer is made one, and faces that then lie on each other back to
/// back are gone. So rounding to much less than `least` makes no faces cross. Corners move by a small multiple of `least`.
/// (The vertex shifting and edge cracking of Milenkovic, "Verifiable implementations of geometric algorithms using finite
/// precision arithmetic", 1988, in space and without a grid.) In strips that are hardly wider, thin triangles may have a
/// corner nearer to their own edge. Nothing where that does not end within some rounds: where details are about as small as
/// `least`, and often where large sheets lie on each other with edges of their own. O(n log n) for each round over triangles
/// that are spread well. @throws Error Cancelled.
std::optional<Mesh> separated(const Mesh& triangles, double least, const Progress& = Progress::none());

}  // namespace blossom::morphology
