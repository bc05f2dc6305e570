#pragma once
#include "geometry/crossing/surface_crossing.h"
#include "geometry/crossing/triangle_pairs.h"

/// The steps of findCrossing after the triangles are made; used inside src/geometry/crossing only.
namespace blossom {

/// Pairs of triangles that are kept for examination.
inline constexpr std::size_t pairsKept = 4000;

/// Share of the size within which triangles follow the surface: two sheets are off by less than the depth together.
inline double chordFor(const CrossingOptions& o) { return 0.4 * o.depth; }

/// Examines pairs of triangles until one is a crossing, and a few more for the deepest. Sheets that cover one another are
/// told of a single surface only.
CrossingResult searchCrossing(const SheetMesh&, const SmoothSheets&, const MeetingTriangles&, const CrossingOptions&,
                              const Progress&);

}  // namespace blossom
