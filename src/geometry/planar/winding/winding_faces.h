#pragma once
#include <optional>
#include <span>

#include "core/progress.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/winding/boundary_rings.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/winding_cells.h"

namespace blossom::planar {

/// Winding numbers that count as inside. Hollow: 0 and below, where enclosed by edges.
enum class Inside { Positive, NonZero, Hollow };

/// The set of points whose winding number with respect to closed cycles of edges is inside, in grid coordinates. What is
/// inside is decided by integers alone; crossings are rounded to doubles only at the end. Outer loops counter-clockwise,
/// holes clockwise; where a boundary touches itself in a point it is split there. The grid of winding_cells.h leaves out
/// what is far from the boundary; elsewhere every edge that may bound is compared with those near it, on all cores.
/// @pre the edges are the sum of closed cycles, as joinEqual returns them.
/// @throws Error Cancelled; TooMuchWork; Internal when the edges are no cycles.
Polygons windingFaces(std::span<const CountedEdge>, const Progress&, Inside, Effort&);
Polygons windingFaces(std::span<const CountedEdge>, const Progress& = Progress::none(), Inside = Inside::Positive);

/// The same with the edge of every side. @throws as windingFaces
std::vector<TracedPart> tracedFaces(std::span<const CountedEdge>, const Progress&, Inside, Effort&);
std::vector<TracedPart> tracedFaces(std::span<const CountedEdge>, const Progress&, WindingRule, Effort&);

/// A corner of a face wider than `width` with a winding number other than 0 and 1, that is, where loops that should bound an
/// area cross or overlap; empty when there is none. @throws as windingFaces
std::optional<Vec2> misplacedFace(std::span<const CountedEdge>, double width, const Progress& = Progress::none());

}  // namespace blossom::planar
