#include "kernel/path/pocket_path.h"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "kernel/path/pocket_cutter.h"

namespace blossom::pocket {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorCode::InvalidParameter, what, hint);
}

/// The options with what was left open filled in.
PocketOptions checkedOptions(PocketOptions o) {
  const double diameter = o.cutter.diameter;
  const auto above = [](double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value))
      refuse(fmt::format("The {} must be above 0; it is {:g}.", name, value), fmt::format("Give a {} above 0.", name));
  };
  const auto fromZero = [](double value, const char* name) {
    if (!(value >= 0) || !std::isfinite(value))
      refuse(fmt::format("The {} must not be below 0; it is {:g}.", name, value), "Give 0 or more.");
  };
  above(diameter, "diameter of the tool");
  fromZero(o.cutter.cornerRadius, "radius of the tool's corners");
  if (o.cutter.cornerRadius > diameter / 2)
    refuse(fmt::format("Corners of {:.4g} mm do not fit on a tool of {:.4g} mm.", o.cutter.cornerRadius, diameter),
           "Give at most half the diameter; that is a ball.");
  above(o.depth, "depth");
  fromZero(o.stepdown, "stepdown");
  fromZero(o.stepover, "stepover");
  fromZero(o.leaveWall, "stock to leave on walls");
  fromZero(o.leaveFloor, "stock to leave on the floor");
  fromZero(o.finish, "finishing allowance");
  above(o.safeHeight, "safe height");
  above(o.approach, "approach height");
  above(o.feed, "feed");
  above(o.plungeFeed, "plunge feed");
  above(o.rampAngle, "ramp angle");
  above(o.tolerance, "tolerance");
  if (o.stepover == 0) o.stepover = 0.45 * diameter;
  if (o.stepdown == 0) o.stepdown = diameter / 2;
  if (o.stepover > diameter * (1 + 1e-12))
    refuse(fmt::format("A stepover of {:.4g} mm is wider than the tool, which is {:.4g} mm: ridges would stay.", o.stepover,
                       diameter),
           "Give at most 100 %; 40 to 50 % is usual.");
  if (o.leaveFloor >= o.depth)
    refuse("The stock to leave on the floor is as thick as the pocket is deep.", "Leave less, or go deeper.");
  if (o.rampAngle > fullTurn / 4 - 1e-3) o.entry = Entry::Plunge;
  constexpr std::size_t maximumDepths = 10000;
  if (o.depth / o.stepdown > maximumDepths)
    throw Error(ErrorCode::LimitExceeded, fmt::format("More than {} depths are needed.", maximumDepths),
                "Use a larger stepdown.");
  return o;
}

}  // namespace

PocketResult pocketPath(const Region& region, const PocketOptions& options, const Progress& progress) {
  return PocketCutter(region, checkedOptions(options), progress).cut();
}

}  // namespace blossom::pocket
