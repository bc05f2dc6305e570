#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/free_points.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// A point of the limit shape and its target position. The point stays fixed during the iteration, while samples of a target
/// find their closest point again in each step.
struct Pull {
  Vec3 at = Vec3::Zero(), to = Vec3::Zero();  ///< the point of the shape closest to `at` is pulled
};

/// Large enough that points with little influence stay calm, small enough that a single pull is followed within one percent.
inline constexpr double defaultLambda = 2.5e-3;

struct DeformOptions {
  FreeRule free = {};
  double lambda = defaultLambda;  ///< weight of the resistance relative to influence (resistanceOf); 0: the shortest
                                  ///< movement that fits best
  int iterations = 20;            ///< maximum number of searches for foot points
  std::vector<Pull> pulls = {};
};

/// Distances of the samples from the limit shape, in mm.
struct Distances {
  double rms = 0, largest = 0;
};

struct DeformResult {
  std::vector<Vec3> points;     ///< all control points; those not free are bitwise unchanged
  std::vector<int> freePoints;  ///< sorted
  std::vector<Foot> feet;       ///< of the samples, then of the pulls
  Distances before, after;
  double farthestMove = 0;        ///< mm, maximum movement of a control point
  int farthestPoint = -1;         ///< index of that point; -1: none moved
  double outsideChange = 0;       ///< mm, maximum movement of the shape outside the support of the free points
  std::vector<double> objective;  ///< minimised function after each solution; non-increasing
  bool beyondRange = false;       ///< more than half of the distance is left
};

/// Moves control points so that the limit shape approximates the samples: closest points on the shape, then least squares
/// over the free points, repeated while the distance decreases. J. G. Li, Local Deformation of Subdivision Curves and
/// Surfaces (2007), with exact rows instead of interpolated ones. Pulls are samples with fixed foot points. O(iterations *
/// (samples + patches) * log patches).
/// @throws Error InvalidInput (neither samples nor pulls, not finite, no free point), InvalidParameter, Degenerate,
/// Cancelled.
DeformResult deform(const LimitShape&, std::span<const Vec3> points, std::span<const Vec3> samples, const DeformOptions&,
                    const Progress& = Progress::none());

}  // namespace blossom::subdivision
