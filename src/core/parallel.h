#pragma once
#include <cstddef>
#include <functional>

#include "core/progress.h"

namespace blossom {

/// Calls body(begin, end) for disjoint ranges that cover [0, count), on all cores. Polls `progress` between ranges.
/// @param grain minimum size of a range
/// May be called in `body`. Returns only when all of [0, count) is done.
/// @throws Error Cancelled, also when a loop around this one is ending because of an exception; the first exception thrown
/// by `body`.
void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Sets the maximum number of threads of parallelFor; 0 means all cores. Applies to calls made afterwards.
void setThreadLimit(int threads);
int threadLimit();

}  // namespace blossom
