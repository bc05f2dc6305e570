#pragma once
#include "exchange/format/format.h"
#include "geometry/planar/region.h"

namespace example {

/// Measures of a gear; lengths in mm, the angle in degrees.
struct Gear {
  int teeth = 20;
  double module = 2;  ///< pitch diameter over number of teeth
  double pressureAngle = 20;
  double bore = 10;  ///< diameter of the hole in the middle; 0: none
};

/// The gear with straight flanks by the reference profile of ISO 53.
/// @throws blossom::Error InvalidParameter when its teeth or its bore leave no gear.
blossom::Region gearOutline(const Gear&);

/// "812.3 mm²", or why there is no such gear.
std::string areaText(const Gear&);

/// Drawings as pen plotters take them (HPGL).
blossom::Format plotterFormat();

}  // namespace example
