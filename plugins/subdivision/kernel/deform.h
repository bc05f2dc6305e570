#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/free_points.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// A place of the limit shape that is taken hold of, and where it is to go. It stays the same place all the time, while
/// samples of a target find the closest one again and again.
struct Pull {
  Vec3 at = Vec3::Zero(), to = Vec3::Zero();  ///< the closest point to `at` counts
};

/// Enough that points which act little stay calm, little enough that a single pull is followed within one percent.
inline constexpr double defaultLambda = 2.5e-3;

struct DeformOptions {
  FreeRule free = {};
  double lambda = defaultLambda;  ///< how much points resist, relative to their influence (resistanceOf); 0: the shortest
                                  ///< movement that fits best
  int iterations = 20;            ///< at most so often feet are found again
  std::vector<Pull> pulls = {};
};

/// Distances of the samples from the limit shape, in mm.
struct Distances {
  double rms = 0, largest = 0;
};

struct DeformResult {
  std::vector<Vec3> points;     ///< all control points; those not free have every bit they had
  std::vector<int> freePoints;  ///< sorted
  std::vector<Foot> feet;       ///< of the samples, then of the pulls
  Distances before, after;
  double farthestMove = 0;        ///< mm, of a control point
  int farthestPoint = -1;         ///< which one; -1: none moved
  double outsideChange = 0;       ///< largest movement, in mm, of the shape where no free point acts
  std::vector<double> objective;  ///< what is minimised, after each solution; never grows
  bool beyondRange = false;       ///< the free points could not follow: more than half of the distance is left
};

/// Moves some control points so that the limit shape runs near the samples: closest points on the shape, least squares over
/// the free points, and again while the distance falls. J. G. Li, Local Deformation of Subdivision Curves and Surfaces
/// (2007), with exact rows in place of interpolated ones. O(iterations * (samples + patches) * log patches).
/// Pulls are samples too, whose feet are held.
/// @throws Error InvalidInput (neither samples nor pulls, not finite, no free point), InvalidParameter, Degenerate,
/// Cancelled.
DeformResult deform(const LimitShape&, std::span<const Vec3> points, std::span<const Vec3> samples, const DeformOptions&,
                    const Progress& = Progress::none());

}  // namespace blossom::subdivision
