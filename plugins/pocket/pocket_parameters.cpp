#include "pocket_parameters.h"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"

namespace blossom::pocket {

namespace {

/// "45%" of the tool's diameter, or a length.
double stepoverOf(const std::string& text, double diameter) {
  const std::size_t mark = text.find('%');
  const bool percent = mark != std::string::npos;
  double step = 0;
  try {
    step = percent ? parseNumber(text.substr(0, mark)) / 100 * diameter : parseLength(text);
  } catch (const Error& error) {
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover \"{}\" is no number: {}", text, error.message()),
                "Write a share of the tool's diameter such as 45%, or a length such as 2.5 mm.");
  }
  if (percent && text.find_first_not_of(" \t", mark + 1) != std::string::npos)
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover \"{}\" goes on after the %.", text),
                "Write 45% or 2.5 mm.");
  if (!(step > 0) || !std::isfinite(step))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover must be above 0; it is \"{}\".", text),
                "40% to 50% of the diameter is usual.");
  return step;
}

}  // namespace

PocketOptions optionsOf(const PocketParameters& p) {
  PocketOptions o;
  o.cutter = {
      .diameter = p.toolDiameter, .cornerRadius = p.toolCorner, .vAngle = 0, .number = p.toolNumber, .spindle = p.spindle};
  o.depth = p.depth;
  o.stepdown = p.stepdown;
  o.stepover = stepoverOf(p.stepover, p.toolDiameter);
  o.climb = p.direction == Direction::Climb;
  o.entry = p.entry;
  o.rampAngle = toRadians(p.rampAngle);
  o.leaveWall = p.leaveWall;
  o.leaveFloor = p.leaveFloor;
  o.finish = p.finish;
  o.safeHeight = p.safeHeight;
  o.approach = p.approach;
  o.feed = p.feed;
  o.plungeFeed = p.plungeFeed;
  o.tolerance = p.tolerance;
  return o;
}

}  // namespace blossom::pocket
