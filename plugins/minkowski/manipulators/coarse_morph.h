#pragma once
#include "parameter/value.h"

/// The morph in less detail, for the time that something is dragged.
namespace blossom::minkowski {

inline constexpr double timesAsCoarse = 16;       ///< as the tolerance that a shape has without one; refused from 50 on
inline constexpr double coarsestTolerance = 0.2;  ///< mm
inline constexpr int fewFrames = 3;               ///< the ends, and the one that is seen
inline constexpr int ghostFrames = 9;             ///< where the others are seen as well

/// Complete parameters with a tolerance of at least so much.
Value coarseParameters(Value parameters, double tolerance);

/// With only `count` frames, one of which is the one that is seen; keys put them where they are in the whole sequence.
/// @param seen the frame that is seen, of all, counted from 0
/// @param place where it is to be among the few
Value fewerFrames(Value parameters, int count, int seen, int place);

}  // namespace blossom::minkowski
