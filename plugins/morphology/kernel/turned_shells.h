#pragma once
#include "kernel/solid_check.h"

namespace blossom::morphology {

/// Turns shells that are inside out, each with a warning: those with fewer than no solid on a side, where the winding number
/// of all shells together is below 0. Shells of voids, which look inwards within others that look outwards, stay. Volumes
/// cannot tell these apart. O(n log n). @pre closed triangles. @throws Error Cancelled.
void turnOutwards(CheckedSolid&, const Subject&, const Progress&);

}  // namespace blossom::morphology
