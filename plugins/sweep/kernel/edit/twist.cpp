#include "kernel/edit/twist.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/edit/edit_places.h"
#include "kernel/quaternion.h"
#include "kernel/vanishing.h"

namespace blossom::sweep {

namespace {

constexpr double radian = 180 / std::numbers::pi;
constexpr double turnedFully = 1e-9 * radian;

void checkTwist(const MotionTwist& t) {
  if (!t.axis.allFinite() || !(t.axis.norm() > 0))
    throw Error(ErrorCode::InvalidParameter, "An axis to twist about needs a length.", "Give a direction, such as 0,0,1.");
  if (!(std::abs(t.angle) <= 360))
    throw Error(ErrorCode::InvalidParameter, "A twist turns by 360 degrees at most, for more is no other orientation.",
                "Give an angle between -360 and 360 degrees.");
}

/// A motion that vanished before is left to what sweeps it: an edit may be about to mend it.
void requireFrames(const Motion& before, const Motion& after, double angle, const Progress& progress) {
  const auto place = vanishingPlace(after.orientation, progress);
  if (!place || vanishingPlace(before.orientation, progress)) return;
  throw Error(
      ErrorCode::Degenerate,
      fmt::format("Twisted by {:.4g} degrees, the orientation would vanish near u = {:.4g}, v = {:.4g}: from there to "
                  "the place of the twist it would turn too far at once.",
                  angle, place->u, place->v),
      "Twist by half of the angle at a coarser level, then by the other half at a finer one, or first at more places "
      "around; two halves at the same places and level are the same twist.");
}

}  // namespace

EditResult twist(const Motion& motion, const MotionTwist& options, const Progress& progress) {
  checkTwist(options);
  EditPlaces edit(motion, options.at, options.pins, options.symmetry, options.level, progress);
  std::vector<Vec4> wanted;
  const auto orientationAt = [&](const EditPlace& place) {
    return evaluate(edit.motion().orientation, place.at.u, place.at.v);
  };
  edit.changeOrientation([&](const EditPlace& place) -> Vec4 {
    const Vec4 r = orientationAt(place);
    const Vec3 axis = place.turn.determinant() * (place.turn * options.axis.normalized());
    wanted.push_back(times(rotationAbout(axis.normalized(), options.angle / radian), r));
    return wanted.back() - r;
  });
  const auto left = [&](const EditPlace& place) {
    return radian * angleBetween(wanted[static_cast<std::size_t>(&place - edit.places().data())], orientationAt(place));
  };
  requireFrames(motion, edit.motion(), options.angle, progress);
  return edit.finished(left, turnedFully, Unreached::TooClose);
}

}  // namespace blossom::sweep
