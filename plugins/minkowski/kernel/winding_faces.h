#pragma once
#include <optional>
#include <span>

#include "core/progress.h"
#include "kernel/convolution.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Which winding numbers count as inside. Hollow: those of 0 and below that the edges enclose.
enum class Inside { Positive, NonZero, Hollow };

/// The set in which closed cycles of edges have such winding numbers, in grid coordinates. Crossings are exact (CGAL's
/// arrangement of segments) and rounded to doubles only at the end; which loops are holes, and of which part, is decided
/// before that. Outer loops counter-clockwise, holes clockwise; where a boundary touches itself in a point it is split
/// there. O((n + k) log n), k the crossings.
/// @pre the edges are the sum of closed cycles, each from the lower to the higher point.
/// @throws Error LimitExceeded when neighbouring edges meet more than twenty million times; Cancelled; TooMuchWork; Internal
/// when the edges are no cycles.
Polygons windingFaces(std::span<const CountedEdge>, const Progress&, Inside, Effort&);
Polygons windingFaces(std::span<const CountedEdge>, const Progress& = Progress::none(), Inside = Inside::Positive);

/// A corner of a face that is wider than `width` and whose winding number is neither 0 nor 1: where loops that should bound
/// an area cross or lie over one another. Nothing when there is none. @throws as windingFaces
std::optional<Vec2> misplacedFace(std::span<const CountedEdge>, double width, const Progress& = Progress::none());

}  // namespace blossom::minkowski
