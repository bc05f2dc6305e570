#pragma once
#include <filesystem>

#include "exchange/format/format.h"

namespace blossom {

/// Reads everything that a 3MF package builds as one mesh in mm. Components and items are placed; mirrored ones are turned
/// inside out, so that closed objects keep their outside. Supports, materials, slices and other content without shape are
/// counted as skipped.
/// Source: 3MF Core Specification 1.3, sections 2 to 4; Production Extension 1.1, section 3 (objects in parts of their own).
/// @throws Error FormatDamaged, LimitExceeded, Cancelled.
Imported readThreeMf(const std::filesystem::path&, const Progress&);

}  // namespace blossom
