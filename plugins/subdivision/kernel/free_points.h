#pragma once
#include <span>
#include <vector>

#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// Which control points may move.
struct FreeRule {
  bool paper = false;  ///< the paper's side-and-projection rule; else the support of the foot points
  int rings = 0;       ///< the support grown by so many rings of neighbours, shrunk when below 0
};

/// The control points that the rows touch with more than rounding. Sorted.
std::vector<int> supportOf(std::span<const Row> rows);

/// Grown by `rings` rings of neighbours in the cage, or shrunk by as many rings from its rim. Sorted.
std::vector<int> grown(std::vector<int> chosen, std::span<const std::pair<int, int>> edges, std::size_t count, int rings);

/// The paper's rule for curves: those on the bulging side of the line through the end samples that project between them;
/// where none does, the two nearest to the end samples. J. G. Li 2007, step 3.
/// @throws Error InvalidInput where no control point lies on that side: beyond the local range.
std::vector<int> paperRuleOnCurve(std::span<const Vec3> samples, std::span<const Vec3> points);

/// The paper's rule for surfaces: those on the bulging side of a plane through three samples that project into the box round
/// the projected samples; where none does, the nearest to each of its corners. When all samples lie in the plane, the side
/// is that of the foot points.
/// @throws Error InvalidInput as above, or when all samples lie on one line.
std::vector<int> paperRuleOnSurface(std::span<const Vec3> samples, std::span<const Vec3> footPoints,
                                    std::span<const Vec3> points);

/// What the shape is to come to: samples of a target first, then the places that pulls go to.
struct Wanted {
  std::span<const Vec3> samples;
  std::span<const Row> rows;  ///< of their feet
  std::size_t drawn = 0;      ///< so many samples are of a target
};

/// The control points that may move. The paper's rule looks at the target alone and adds the support of the pulls beside it;
/// without a target the places that the pulls go to are one. Sorted, never empty.
/// @throws Error InvalidInput as above, and when no point is left.
std::vector<int> freePoints(const FreeRule&, const Wanted&, std::span<const Vec3> points,
                            std::span<const std::pair<int, int>> edges, bool isCurve);

/// How much free points resist being moved.
struct Resistance {
  /// What lambda is relative to: the largest sum of squares of the weights that a free point has in the samples, so that
  /// twice as many samples change nothing. More where no sample depends on the free points as a sample among points that are
  /// all free does: the paper's rule may free none but points that hardly act.
  double strongest = 1;
  /// Of each free point: 1 for the one that acts most, more for those that act less, as their sum of squares is less. Points
  /// at the rim of the support, which hardly act, would else run far off for a hair's breadth. 1 for points that do not act
  /// at all, which nothing but their neighbours moves.
  std::vector<double> shares;
};
Resistance resistanceOf(std::span<const Row> rows, std::span<const int> free);

}  // namespace blossom::subdivision
