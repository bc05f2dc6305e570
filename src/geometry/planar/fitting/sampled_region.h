#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/fitting/true_curve.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/polygons/sound_set.h"

namespace blossom::planar {

/// An arc or a free-form curve of a boundary that has the material to its left.
struct BoundaryCurve {
  bool isFree = false;
  Vec2 centre = Vec2::Zero();  ///< of an arc
  double radius = 0;           ///< of an arc; above 0 when the material is on the side of the centre
};

/// An edge of a polygon that stands for a line or for part of a curve.
struct SampledSide {
  Vec2 from, to;
  double normal = 0;                     ///< angle of the outward normal of the side
  double normalFrom = 0, normalTo = 0;   ///< the same of the curve, at the ends of the side
  std::optional<std::uint32_t> curve{};  ///< number of the curve
};

/// A corner of a polygon, and the curves that meet there. Curves that turn right are left out, for no edge that is moved
/// along them bounds a sum.
struct SampledCorner {
  Vec2 at;
  std::optional<std::uint32_t> before{}, after{};  ///< equal within a curve
  double normalBefore = 0, normalAfter = 0;        ///< angles of the outward normals of the curves there
};

/// The corners of an open curve there and back, so many sides each way; the first one is its start, and the one after
/// `sides` others its end. Without sides: a point.
struct ThereAndBack {
  std::uint32_t first = 0, sides = 0;
};

/// A region as polygons whose corners lie on it. Number i is a corner and the side that begins there.
struct SampledRegion {
  Polygons polygons;
  std::vector<ThereAndBack> thin{};  ///< curves and points beside the region, whose corners come last
  std::vector<SampledCorner> corners;
  std::vector<SampledSide> sides;
  std::vector<BoundaryCurve> curves;
};

/// Angles of the normals of a shape at which another one is to be cut, sorted, 0 to 2 pi: those at the ends of arcs and of
/// the samples of splines and, where the other has splines, of the lines when they are few. Where that would be too many
/// cuts, the four directions of the axes.
/// @param share of the tolerance
std::vector<double> normalsOf(const SoundRegion&, const SoundRegion& other, double share);

/// Where the polygons of a sampled region may lie.
enum class Sampling {
  Chords,  ///< corners on the arcs
  Around,  ///< never inside of the region: sides that touch arcs with the material inside, chords of the others
};

/// How far a chord of an arc turns at most, radians, for all of it to be within the tolerance.
double arcStep(double radius, double tolerance);

/// Polygons within a share of the tolerance, and curves and points if there are any. Curves are cut at the normals, so that
/// each chord of an arc belongs to one set of curves of the other region with the same normals, and arcs between them in a
/// power of two of equal parts, so that chords of arcs with the same normals tend to be parallel. @pre without splines, or
/// Sampling::Chords
SampledRegion sampled(const SoundRegion&, double share, const std::vector<double>& normals, Sampling,
                      const Progress& = Progress::none());
SampledRegion sampled(const SoundSet&, double share, const std::vector<double>& normals, Sampling, const Progress&);

/// The normals of both, each with its opposite, which curves have on their two sides.
std::vector<double> normalsOf(const SoundSet&, const SoundSet& other, double share);

/// The curve on which x + y lies for points x of a side and those of another region at a convex corner whose turn contains
/// the direction of the side: a side moved by the corner or, where the corner stands for an arc, by the arc's point with the
/// same normal. Of two arcs it is the circle about the sum of the centres with the sum of the radii (Lee, Lee, Kim & Kim
/// 2002, section 3.1). What comes from splines is free. Nothing when that circle is smaller than `point`.
std::optional<TrueCurve> curveOfPair(const SampledRegion& ofSide, std::uint32_t side, const SampledRegion& ofCorner,
                                     std::uint32_t corner, double point);

/// Within which corners of polygons and of curves correspond: the longest chord, about which crossings of nearly tangent
/// curves move.
double longestChord(const SampledRegion&);

/// How far rounding to a grid and that of numbers move points and the centres and radii of arcs, with room for sums of two.
double roundingOf(const SampledRegion&, const Grid&);

}  // namespace blossom::planar
