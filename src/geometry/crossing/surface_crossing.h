#pragma once
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <optional>

#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/crossing/smooth_sheets.h"

namespace blossom {

struct CrossingOptions {
  /// Share of the size. Crossings deeper than that are looked for; shallower ones are told where they are noticed.
  double depth = 1e-3;
};

/// Where a surface passes through itself.
struct SurfaceCrossing {
  Vec3 point = Vec3::Zero();  ///< mm, on both sheets
  SheetPlace first, second;   ///< face and parameters on either sheet; the face is 0 for a single surface
  double depth = 0;           ///< mm, how far one sheet reaches on either side of the other, at least: the lesser side
};

struct CrossingResult {
  std::optional<SurfaceCrossing> deepest;  ///< of the places that were examined; nothing when there is none
  /// Of a single surface: a place around which sheets of it cover one another, which is no crossing but no sound surface.
  std::optional<Vec3> covered;
  double size = 0;                                     ///< mm, diagonal of the box around the shape
  std::size_t triangles = 0, pairs = 0, meetings = 0;  ///< searched, found to meet, and confirmed on the smooth surface
  std::size_t divided = 0;  ///< triangles that were made or taken around the meetings, which is most of the work there
};

/// Whether a smooth surface crosses itself. Its triangles, within two fifths of the depth, are searched for pairs that meet
/// (geometry/crossing/triangle_pairs.h); Newton's method on the smooth sheets leaves only pairs that meet on these as well
/// (geometry/crossing/smooth_sheets.h); and around such a place one sheet must have points on both sides of the other
/// (geometry/crossing/local_sheets.h): on one side as deep as is looked for, on the other, where there may be only a slit,
/// at least a share of 0.04 of that. So triangles of a thin wall that cross, sheets that touch, seams and poles do not
/// count. Where sheets are tangent, three places far from one another are examined, and the first ball around each in which
/// the sheets part must show both sides. Where all sheets of a place meet in a point and hang together around it, as at the
/// tips of a spindle torus, the surface is no crossing here: it has no normal there. Also open surfaces; O(n log n) in the
/// triangles.
/// @throws as tessellate
CrossingResult findCrossing(const Surface&, const CrossingOptions& = {}, const Progress& = Progress::none());

/// The same for the faces of a shape together: solids, shells, and several of them.
CrossingResult findCrossing(const TopoDS_Shape&, const CrossingOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom
