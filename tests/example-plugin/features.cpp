#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/units.h"
#include "feature/plugin.h"

namespace {

using namespace blossom;

struct GearParameters {
  int teeth = 20;
  double module = 2.0_mm;
  double pressureAngle = 20.0_deg;
  double bore = 10.0_mm;
};

/// Radii in mm, half-angles of a tooth in radians.
struct Profile {
  double rootRadius, tipRadius, rootHalfAngle, tipHalfAngle;
};

/// Reference profile of ISO 53 (addendum 1 module, dedendum 1.25 modules) with straight flanks. Half the tooth is a quarter
/// of the pitch wide at the pitch circle and narrows outwards with the tangent of the pressure angle.
Profile profile(const GearParameters& p) {
  const double pitchRadius = p.module * p.teeth / 2;
  const double half = std::numbers::pi * p.module / 4, slope = std::tan(p.pressureAngle * std::numbers::pi / 180);
  const double rootRadius = pitchRadius - 1.25 * p.module, tipRadius = pitchRadius + p.module;
  const Profile result{rootRadius, tipRadius, (half + 1.25 * p.module * slope) / rootRadius,
                       (half - p.module * slope) / tipRadius};
  if (result.tipHalfAngle <= 0 || result.rootHalfAngle >= std::numbers::pi / p.teeth)
    throw Error(ErrorCode::InvalidParameter, "The teeth run into each other or end in a point.",
                "Take more teeth or a smaller pressure angle.");
  if (p.bore / 2 >= rootRadius)
    throw Error(ErrorCode::InvalidParameter, "The bore leaves nothing of the gear.",
                "Make the bore smaller than the root circle.");
  return result;
}

Path outline(const GearParameters& p) {
  const Profile tooth = profile(p);
  const double step = 2 * std::numbers::pi / p.teeth;
  const auto at = [](double radius, double angle) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
  const auto arc = [](double radius, double from, double to) { return Arc2{Vec2(0, 0), radius, from, to - from}; };
  Path path;
  path.closed = true;
  for (int i = 0; i < p.teeth; ++i) {
    const double middle = i * step;
    const double rise = middle - tooth.rootHalfAngle, fall = middle + tooth.rootHalfAngle;
    path.segments.push_back(Line2{at(tooth.rootRadius, rise), at(tooth.tipRadius, middle - tooth.tipHalfAngle)});
    path.segments.push_back(arc(tooth.tipRadius, middle - tooth.tipHalfAngle, middle + tooth.tipHalfAngle));
    path.segments.push_back(Line2{at(tooth.tipRadius, middle + tooth.tipHalfAngle), at(tooth.rootRadius, fall)});
    path.segments.push_back(arc(tooth.rootRadius, fall, rise + step));
  }
  return path;
}

Evaluated gear(const GearParameters& p, const Inputs&, const Progress& progress) {
  progress.check();
  Region region;
  region.loops.push_back(outline(p));
  if (p.bore > 0) {
    Path hole;
    hole.closed = true;
    hole.segments.push_back(Arc2{Vec2(0, 0), p.bore / 2, 0, -2 * std::numbers::pi});
    region.loops.push_back(std::move(hole));
  }
  return {region, {{"pitch_diameter", p.module * p.teeth}}, {}};
}

FeatureType gearFeature() {
  using P = GearParameters;
  return feature<P>("example.gear", "Gear", "The outline of a toothed wheel with straight flanks.")
      .produces({ShapeKind::Region})
      .parameter("teeth", &P::teeth, count(5, 1000), "Number of teeth.")
      .parameter("module", &P::module, positiveLength(), "Pitch diameter over number of teeth.")
      .parameter("pressure-angle", &P::pressureAngle, angle(), "Slope of the flanks.")
      .parameter("bore", &P::bore, length(), "Diameter of the hole in the middle; 0 for none.")
      .example("blossom gear --teeth 24 --module 1.5 -o gear.dxf")
      .evaluate(gear);
}

}  // namespace

BLOSSOM_PLUGIN(registry) { registry.add(gearFeature()); }
