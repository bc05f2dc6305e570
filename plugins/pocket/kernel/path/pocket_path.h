#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

/// Entry of the tool into solid material.
enum class Entry { Ramp, Helix, Plunge };

/// Lengths in mm, angles in radians, feeds in mm/min. The top of the part is at z = 0.
struct PocketOptions {
  Cutter cutter;
  double depth = 0;
  double stepdown = 0;  ///< maximum depth per step; 0: half the diameter
  double stepover = 0;  ///< distance between passes, at most the diameter; 0: 45 % of it
  bool climb = true;
  Entry entry = Entry::Ramp;
  double rampAngle = 0.05;
  double leaveWall = 0, leaveFloor = 0;
  double finish = 0;  ///< stock left on the walls by the passes and removed at full depth at the end
  double safeHeight = 5;
  double approach = 1;  ///< height above material where rapids end
  double feed = 800, plungeFeed = 200;
  double tolerance = 0.005;
};

struct PocketResult {
  Toolpath path;
  std::size_t depths = 0, loops = 0, spokes = 0, entries = 0;
  std::vector<Vec2> tooNarrow;  ///< places of parts of the region that are too narrow for the tool
  std::size_t plunged = 0;      ///< number of entries without room for a ramp or helix
};

/// Clears a region down to a depth: passes parallel to the walls from the inside outwards, at equal depth steps, around
/// islands, with spokes along the medial axis where a large stepover would leave material (see passTree). The tool stays
/// down from pass to pass when its centre stays in the allowed area and the move is short; else it retracts.
/// Source: Held, "On the Computational Geometry of Pocket Machining", 1991, for the order of offset curves.
/// @throws Error InvalidParameter (naming what is out of range), InvalidInput (the tool fits nowhere, with the largest that
/// does; a region that ClearanceDiagram refuses), LimitExceeded, Cancelled.
PocketResult pocketPath(const Region&, const PocketOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
