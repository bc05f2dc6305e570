#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "feature/feature_type.h"

namespace blossom {

/// The second of two ways to the same result, either of which may take unforeseeably longer than the other.
using Attempt = std::function<Evaluated(const Progress&)>;

/// Runs `first`, and `second` beside it once `headStart` seconds have passed; each in a thread of its own and with a
/// Progress of its own, by which it is cancelled. The first result wins and the other is cancelled; all have ended when this
/// returns. Only `first` reports to `progress`.
/// @throws Error what `first` throws, which ends `second`: both look at the same input with the same eyes. Only when it is
/// Internal (a result that did not pass the checks) `second` is waited for. What `second` throws counts as no result.
/// Cancelled within 20 ms and the time the attempts take to notice.
Evaluated firstOf(const Attempt& first, const Attempt& second, double headStart, const Progress& progress);

}  // namespace blossom
