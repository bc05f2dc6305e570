#pragma once
#include <vector>

#include "core/progress.h"
#include "kernel/arrangement/candidates.h"

namespace blossom::morphology::arrangement {

/// A segment in which two facets meet, or a point.
struct Meeting {
  int from = 0, to = 0;       ///< points; the same where no more is common
  int first = 0, second = 0;  ///< facets
};

/// Where facets of different planes meet, but for whole edges and corners of both. O(n log n + k) for k pairs of facets
/// whose boxes meet. @throws Error Cancelled.
std::vector<Meeting> meetings(const std::vector<Facet>&, const Planes&, Points&, const Progress&);

}  // namespace blossom::morphology::arrangement
