#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/shape/setup.h"
#include "part_input.h"
#include "pocket_heights.h"
#include "pocket_parameters.h"

namespace blossom::pocket {

/// Where a path that begins to cut at z = 0 lies on the machine.
struct PocketPlace {
  Bounds stock;                ///< in the coordinates of the path
  Vec3 toWork = Vec3::Zero();  ///< from there to the work's zero
};

/// In a stock of its own around the part, or around the solid whose face it is.
/// @throws Error InvalidParameter when the stock is too thin.
PocketPlace placeOfItsOwn(const PocketParameters&, const Part&, const PocketHeights&);

/// The place of the zero of a part's region in a setup; empty where the part does not look up there.
std::optional<Vec3> planeIn(const Setup&, const Part&);

/// In a setup: the pocket is cut from the top of its stock, and the tool crosses above everything in it. Raises the heights.
/// @throws Error InvalidInput when the face does not look up in the setup.
PocketPlace placeInSetup(const Setup&, const Part&, PocketHeights&);

}  // namespace blossom::pocket
