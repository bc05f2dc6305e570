#pragma once
#include <cstddef>
#include <functional>

#include "core/progress.h"

namespace blossom {

/// Calls body(begin, end) for disjoint ranges that cover [0, count), on all cores. Polls `progress` between ranges.
/// @param grain smallest range worth a task of its own
/// @throws Error Cancelled; the first exception of a body.
void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Most threads that parallelFor uses; 0 means all cores. Applies to calls made after it returns.
void setThreadLimit(int threads);

}  // namespace blossom
