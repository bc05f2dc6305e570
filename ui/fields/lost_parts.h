#pragma once
#include <optional>
#include <vector>

#include "naming/likeness.h"

namespace blossom::ui {

/// Whether a part is one of those that were not found again.
bool isLost(const Value& part, const std::vector<Value>& lost);

/// The place in a list of the lost part that a picked one stands for: the one that looks the same and lies where it lies,
/// else the nearest of the same form, not farther away than half its size. Nothing when none is near.
std::optional<std::size_t> lostPartFor(const Likeness& picked, const Value& parts, const std::vector<Value>& lost);

}  // namespace blossom::ui
