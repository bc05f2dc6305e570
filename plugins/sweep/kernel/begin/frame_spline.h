#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/curve.h"
#include "kernel/begin/smooth_curve.h"

namespace blossom::sweep {

struct FrameSplineOptions {
  double tolerance = 1e-5;         ///< radians, largest angle between the spline's frames and the true ones
  std::size_t spans = 8;           ///< at least
  std::size_t maximumSpans = 512;  ///< at most
  Vec3 normal{0, 0, 0};            ///< of the first frame; see FrameOptions
};

struct FrameSpline {
  Curve quaternions;           ///< cubic, clamped, over 0..1; x is the normal, y the binormal, z the tangent
  std::vector<double> coarse;  ///< breaks it started from: those of the curve and even ones, `spans` or a few more
  double deviation = 0;        ///< radians, measured at 16 places of each span, with the uncertainty of the frames there
  double closing = 0;          ///< radians, as in FrameResult
  std::size_t spans = 0;
};

/// Quaternions of the rotation-minimising frames as a cubic B-spline. It interpolates the frames at its breaks, C2 where
/// their turning is smooth and with their true derivative q' = (0, w) q / 2 at the ends and at the knots of the curve that
/// let the turning jump. Spans that miss the tolerance are halved. On a closed curve both ends are the same rotation with
/// the same derivative. Order 4 in the length of the spans.
/// @throws Error LimitExceeded with the place and the angle reached; those of rotationMinimizingFrames. O(spans).
FrameSpline fitFrames(const SmoothCurve&, const FrameSplineOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::sweep
