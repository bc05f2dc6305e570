#pragma once
#include <functional>
#include <optional>
#include <string>

#include "core/progress.h"

namespace blossom::modeling {

/// The largest size below `failing` for which `works` holds, to 0.1 %, by bisection; nothing when not even a thousandth
/// works. At most 21 attempts, each preceded by a look at the progress. `works` may throw Standard_Failure.
std::optional<double> largestSize(double failing, const std::function<bool(double size)>& works, const Progress&);

/// "about 4.998": four digits, rounded down, so that the number told works.
std::string roundedDown(double size);

}  // namespace blossom::modeling
