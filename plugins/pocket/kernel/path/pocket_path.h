#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

/// How the tool gets down into full material.
enum class Entry { Ramp, Helix, Plunge };

/// Lengths in mm, angles in radians, feeds in mm a minute. The part's top lies at z = 0.
struct PocketOptions {
  Cutter cutter;
  double depth = 0;
  double stepdown = 0;  ///< most that one pass goes deeper; 0: half the diameter
  double stepover = 0;  ///< from pass to pass, at most the diameter; 0: 45 % of it
  bool climb = true;
  Entry entry = Entry::Ramp;
  double rampAngle = 0.05;
  double leaveWall = 0, leaveFloor = 0;
  double finish = 0;  ///< left by the passes and taken off the walls at full depth at the end
  double safeHeight = 5;
  double approach = 1;  ///< above material, where rapids end
  double feed = 800, plungeFeed = 200;
  double tolerance = 0.005;
};

struct PocketResult {
  Toolpath path;
  std::size_t depths = 0, loops = 0, spokes = 0, entries = 0;
  std::vector<Vec2> tooNarrow;  ///< where a part of the region lets the tool in nowhere
  std::size_t plunged = 0;      ///< entries that had no room for the ramp or helix wanted
};

/// Clears a region down to a depth: passes parallel to the walls from the inside outwards, at each of even depths, islands
/// left standing, spokes along the medial axis where wide steps would leave something (see passTree). The tool stays down
/// from pass to pass as long as its centre stays where it may be and the way is short; else it lifts.
/// Source: Held, "On the Computational Geometry of Pocket Machining", 1991, for the order of offset curves.
/// @throws Error InvalidParameter (with what is out of range), InvalidInput (the tool fits nowhere: the message tells the
/// largest that would; a region that ClearanceDiagram refuses), LimitExceeded, Cancelled.
PocketResult pocketPath(const Region&, const PocketOptions&, const Progress& = Progress::none());

}  // namespace blossom::pocket
