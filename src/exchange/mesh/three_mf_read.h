#pragma once
#include <filesystem>

#include "exchange/format/format.h"

namespace blossom {

/// All that a 3MF package builds, as one mesh in mm: components and items are placed, mirrored ones turned inside out again,
/// so that a closed object stays one. Supports, materials, slices and what else is no shape is counted as skipped.
/// Source: 3MF Core Specification 1.3, sections 2 to 4; Production Extension 1.1, section 3 (objects in parts of their own).
/// @throws Error FormatDamaged, LimitExceeded, Cancelled.
Imported readThreeMf(const std::filesystem::path&, const Progress&);

}  // namespace blossom
