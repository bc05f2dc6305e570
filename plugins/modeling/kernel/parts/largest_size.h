#pragma once
#include <functional>
#include <optional>
#include <string>

#include "core/progress.h"

namespace blossom::modeling {

/// The largest size below `failing` for which `works` returns true, to 0.1 %, by bisection; empty when even a thousandth of
/// it fails. At most 21 calls; polls `progress` before each. `works` may throw Standard_Failure.
std::optional<double> largestSize(double failing, const std::function<bool(double size)>& works, const Progress&);

/// "about 4.998": four digits, rounded down so that the printed size works.
std::string roundedDown(double size);

}  // namespace blossom::modeling
