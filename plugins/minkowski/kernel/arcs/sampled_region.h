#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/planar/region.h"
#include "kernel/arcs/true_curve.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// An arc of a boundary that has the material to its left.
struct BoundaryArc {
  Vec2 centre;
  double radius = 0;  ///< above 0 when the material is on the side of the centre
};

/// An edge of a polygon that stands for a line or for part of an arc.
struct SampledSide {
  Vec2 from, to;
  double normal = 0;                 ///< angle of the outward normal of the side
  std::optional<std::uint32_t> arc;  ///< number of the arc
};

/// A corner of a polygon, and the arcs that meet there.
struct SampledCorner {
  Vec2 at;
  std::optional<std::uint32_t> before, after;  ///< equal within an arc
  double normalBefore = 0, normalAfter = 0;    ///< angles of the outward normals of the arcs there
};

/// A region of lines and arcs as polygons whose corners lie on it. Number i is a corner and the side that begins there.
struct SampledRegion {
  Polygons polygons;
  std::vector<SampledCorner> corners;
  std::vector<SampledSide> sides;
  std::vector<BoundaryArc> arcs;
};

/// Angles of the normals at the ends of all arcs of two regions, sorted, 0 to 2 pi.
std::vector<double> endNormals(const Region&, const Region&);

/// Where the polygons of a sampled region may lie.
enum class Sampling {
  Chords,  ///< corners on the arcs
  Around,  ///< never inside of the region: sides that touch arcs with the material inside, chords of the others
};

/// Polygons within the tolerance of a region whose loops are sorted into parts and consist of lines and arcs. Arcs are cut
/// at the normals, so that each chord belongs to one set of arcs of the other region with the same normals, and between them
/// in a power of two of equal parts, so that chords of arcs with the same normals tend to be parallel.
SampledRegion sampled(const Region&, const std::vector<double>& normals, double tolerance, Sampling = Sampling::Chords);

/// The curve on which x + y lies for points x of a side and those of another region at a convex corner whose turn contains
/// the direction of the side: a side moved by the corner or, where the corner stands for an arc, by the arc's point with the
/// same normal. Of two arcs it is the circle about the sum of the centres with the sum of the radii (Lee, Lee, Kim & Kim
/// 2002, section 3.1). Nothing when that circle is smaller than `point`.
std::optional<TrueCurve> curveOfPair(const SampledRegion& ofSide, std::uint32_t side, const SampledRegion& ofCorner,
                                     std::uint32_t corner, double point);

}  // namespace blossom::minkowski
