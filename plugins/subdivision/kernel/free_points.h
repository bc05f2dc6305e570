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

}  // namespace blossom::subdivision
