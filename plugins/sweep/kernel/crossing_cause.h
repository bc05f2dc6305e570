#pragma once
#include <string>

#include "core/vector.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// Why a swept surface crosses itself, and what to do: two halves of sentences for users.
struct CrossingCause {
  std::string cause, remedy;
};

/// @param first, second  parameters (u, v) of the two places of the surface that are one place in space
CrossingCause causeOfCrossing(const Motion&, const Vec2& first, const Vec2& second);

}  // namespace blossom::sweep
