#pragma once
#include <cstddef>
#include <optional>

#include "core/progress.h"
#include "geometry/shape/motion.h"
#include "kernel/begin/polar_profile.h"

namespace blossom::sweep {

struct CurveMotionOptions {
  double radius = 5;                         ///< mm, of a round section; unused with a profile
  std::optional<PolarProfile> profile = {};  ///< of the section instead
  double tolerance = 1e-3;                   ///< mm, largest distance from the true tube at equal parameters
  std::size_t rows = 12;                     ///< spans around, at least 4
  std::size_t columns = 8;                   ///< spans along, at least
  std::size_t maximumSpans = 512;            ///< at most, in each direction
  Vec3 normal{0, 0, 0};                      ///< direction of the section's x axis at the start; zero: see FrameOptions
};

struct CurveMotionResult {
  Motion motion;
  bool closed = false;         ///< the curve closes, and the motion with it
  double cornerAtEnds = 0;     ///< radians, between the ends of a curve that closes with a corner, whose motion stays open
  double deviation = 0;        ///< mm, measured; see motionFromCurve
  double frameDeviation = 0;   ///< radians, of the orientation from the true frames
  double closing = 0;          ///< radians, of a closed curve; see FrameResult
  std::size_t frameSpans = 0;  ///< spans of the orientation along v
  double smallestBend = 0;     ///< mm, smallest radius of curvature found at samples; 0 for a straight curve
  double bendAt = 0;           ///< its parameter v
  double reach = 0;            ///< mm, largest distance of the section from the curve
};

/// A motion that carries a section along a curve without spinning it (Wang, Juettler, Zheng & Liu 2008). Trajectory: the
/// curve itself, over 0..1. Orientation: the rotation-minimising frame at v times a full turn in u about its tangent, a
/// tensor product. Scaling: the radius of the section along the frame's x axis, constant in v. The swept point is (1, 1, 1)
/// and the other two factors are 0, so that a later pull by scaling alone can reach every place.
///
/// The true tube is c(v) + rho(u) (cos a(u) n(v) + sin a(u) b(v)). The deviation adds what the frames and the profile miss
/// where they are measured: reach * 2 sin(frameDeviation / 2) + the deviation of the radius. A circle has no deviation of
/// its own.
/// @throws Error those of SmoothCurve, fitFrames and fitProfile; InvalidParameter for sizes out of range. O(spans).
CurveMotionResult motionFromCurve(const Curve&, const CurveMotionOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::sweep
