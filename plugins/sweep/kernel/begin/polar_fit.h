#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "kernel/begin/polar_profile.h"

namespace blossom::sweep {

struct PolarFitOptions {
  double tolerance = 5e-4;         ///< mm, largest distance along the rays from the centre
  std::size_t rows = 12;           ///< spans of the turn, and the least number of spans of the radius
  std::size_t maximumSpans = 512;  ///< at most
};

struct PolarFit {
  std::vector<double> period;  ///< knots of the radius over 0..1, corners three times, as `unwrapped` takes them
  std::vector<double> radii;   ///< one pole for each knot but the last
  double start = 0;            ///< radians, the angle of the profile at u = 0; corners lie away from there
  double deviation = 0;        ///< mm, measured at 16 places of each span
};

/// The radius of a profile as a closed cubic B-spline over the parameter u of a full turn (ClosedTurn): C2 but at the
/// corners, which it meets. Spans that miss the tolerance are halved.
/// @throws Error LimitExceeded with the deviation reached; Cancelled. O(spans).
PolarFit fitProfile(const PolarProfile&, const PolarFitOptions& = {}, const Progress& = Progress::none());

}  // namespace blossom::sweep
