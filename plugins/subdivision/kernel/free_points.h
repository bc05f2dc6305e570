#pragma once
#include <span>
#include <vector>

#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// Rule for the control points that may move.
struct FreeRule {
  bool paper = false;  ///< the side-and-projection rule of the paper; else the support of the foot points
  int rings = 0;       ///< rings of neighbours added to the support; removed when negative
};

/// The control points with a weight above rounding in the rows. Sorted.
std::vector<int> supportOf(std::span<const Row> rows);

/// `chosen` grown by `rings` rings of neighbours in the cage, or shrunk by as many from its border. Sorted.
std::vector<int> grown(std::vector<int> chosen, std::span<const std::pair<int, int>> edges, std::size_t count, int rings);

/// The rule of the paper for curves: control points on the bulging side of the line through the end samples that project
/// between them; if there are none, the two nearest to the end samples. J. G. Li 2007, step 3.
/// @throws Error InvalidInput when no control point lies on that side: beyond the local range.
std::vector<int> paperRuleOnCurve(std::span<const Vec3> samples, std::span<const Vec3> points);

/// The rule of the paper for surfaces: control points on the bulging side of a plane through three samples that project into
/// the box of the projected samples; if there are none, the nearest to each of its corners. When all samples are coplanar,
/// the side is that of the foot points.
/// @throws Error InvalidInput as above, or when all samples are collinear.
std::vector<int> paperRuleOnSurface(std::span<const Vec3> samples, std::span<const Vec3> footPoints,
                                    std::span<const Vec3> points);

/// Target of a deformation: samples first, then the target positions of pulls.
struct Wanted {
  std::span<const Vec3> samples;
  std::span<const Row> rows;  ///< of their foot points
  std::size_t drawn = 0;      ///< number of samples of a target
};

/// The control points that may move. The rule of the paper considers only the target and adds the support of the pulls;
/// without a target the positions of the pulls are the target. Sorted, never empty.
/// @throws Error InvalidInput as above, and when no point is left.
std::vector<int> freePoints(const FreeRule&, const Wanted&, std::span<const Vec3> points,
                            std::span<const std::pair<int, int>> edges, bool isCurve);

/// Resistance of free points to being moved.
struct Resistance {
  /// Scale of lambda: the maximum over the free points of the sum of their squared weights in the samples, so that
  /// doubling the samples changes nothing. Larger when no sample depends on the free points as much as a sample between
  /// free points only would, because the rule of the paper may choose only points with little influence.
  double strongest = 1;
  /// Per free point: 1 for the one with the largest sum of squares, more for the others in inverse proportion. Points
  /// at the border of the support would otherwise move far for a tiny improvement. 1 for points without influence, which
  /// are moved only by their neighbours.
  std::vector<double> shares;
};
Resistance resistanceOf(std::span<const Row> rows, std::span<const int> free);

}  // namespace blossom::subdivision
