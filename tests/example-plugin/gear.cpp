#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "core/error.h"
#include "example.h"
#include "geometry/planar/planar.h"

namespace example {

using namespace blossom;

namespace {

/// Radii in mm, half-angles of a tooth in radians.
struct Profile {
  double rootRadius, tipRadius, rootHalfAngle, tipHalfAngle;
};

/// Addendum 1 module, dedendum 1.25 modules. Half the tooth is a quarter of the pitch wide at the pitch circle and narrows
/// outwards with the tangent of the pressure angle.
Profile profile(const Gear& gear) {
  const double pitchRadius = gear.module * gear.teeth / 2;
  const double half = std::numbers::pi * gear.module / 4, slope = std::tan(gear.pressureAngle * std::numbers::pi / 180);
  const double rootRadius = pitchRadius - 1.25 * gear.module, tipRadius = pitchRadius + gear.module;
  const Profile result{rootRadius, tipRadius, (half + 1.25 * gear.module * slope) / rootRadius,
                       (half - gear.module * slope) / tipRadius};
  if (result.tipHalfAngle <= 0 || result.rootHalfAngle >= std::numbers::pi / gear.teeth)
    throw Error(ErrorCode::InvalidParameter, "The teeth run into each other or end in a point.",
                "Take more teeth or a smaller pressure angle.");
  if (gear.bore / 2 >= rootRadius)
    throw Error(ErrorCode::InvalidParameter, "The bore leaves nothing of the gear.",
                "Make the bore smaller than the root circle.");
  return result;
}

Path teeth(const Gear& gear) {
  const Profile tooth = profile(gear);
  const double step = 2 * std::numbers::pi / gear.teeth;
  const auto at = [](double radius, double angle) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
  const auto arc = [](double radius, double from, double to) { return Arc2{Vec2(0, 0), radius, from, to - from}; };
  Path path;
  path.closed = true;
  for (int i = 0; i < gear.teeth; ++i) {
    const double middle = i * step;
    const double rise = middle - tooth.rootHalfAngle, fall = middle + tooth.rootHalfAngle;
    path.segments.push_back(Line2{at(tooth.rootRadius, rise), at(tooth.tipRadius, middle - tooth.tipHalfAngle)});
    path.segments.push_back(arc(tooth.tipRadius, middle - tooth.tipHalfAngle, middle + tooth.tipHalfAngle));
    path.segments.push_back(Line2{at(tooth.tipRadius, middle + tooth.tipHalfAngle), at(tooth.rootRadius, fall)});
    path.segments.push_back(arc(tooth.rootRadius, fall, rise + step));
  }
  return path;
}

}  // namespace

Region gearOutline(const Gear& gear) {
  Region region;
  region.loops.push_back(teeth(gear));
  if (gear.bore > 0) {
    Path hole;
    hole.closed = true;
    hole.segments.push_back(Arc2{Vec2(0, 0), gear.bore / 2, 0, -2 * std::numbers::pi});
    region.loops.push_back(std::move(hole));
  }
  return region;
}

std::string areaText(const Gear& gear) {
  try {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << area(gearOutline(gear)) << " mm²";
    return text.str();
  } catch (const Error& error) {
    return error.message();
  }
}

}  // namespace example
