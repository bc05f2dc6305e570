// What G codes change.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/units.h"
#include "exchange/gcode/gcode_codes.h"
#include "exchange/gcode/gcode_parser.h"

namespace blossom {

namespace {

/// How the tool moves after a G code, given in tenths; empty when the code does not say.
std::optional<GcodeMotion> motionOfMode(int tenths) {
  switch (tenths) {
    case 0:
      return GcodeMotion::Rapid;
    case 10:
      return GcodeMotion::Line;
    case 20:
      return GcodeMotion::Clockwise;
    case 30:
      return GcodeMotion::Counterclockwise;
    case 52:
      return GcodeMotion::Nurbs;
    case 800:
      return GcodeMotion::None;
    default:
      return {};
  }
}

/// The axis that is normal to the plane of arcs after a G code; empty when the code selects no plane.
std::optional<int> normalOfPlane(int tenths) {
  switch (tenths) {
    case 170:
      return 2;
    case 180:
      return 1;
    case 190:
      return 0;
    default:
      return {};
  }
}

}  // namespace

void GcodeParser::watchModes(const Block& block) {
  if (block.length)
    watch_.lengthFrom(block.lengthNumber);
  else if (block.lengthNumber)
    watch_.lengthNumber(*block.lengthNumber);
  if (!block.blends) return;
  const bool evaluated = block.weight || !block.saysP;
  if (evaluated && !(block.weight.value_or(0) > 0)) watch_.blendsWithoutLimit();
  if (!block.weight) return;
  const double blending = *block.weight * unit_;
  watch_.blends(blending);
  program_.blending = std::max(program_.blending, blending);
}

void GcodeParser::mode(double code, Block& block) {
  const int tenths = std::abs(code) < 1000 ? static_cast<int>(std::lround(code * 10)) : -1;
  if (motion_ == GcodeMotion::Nurbs && tenths != 52) finishNurbs();
  if (const auto motion = motionOfMode(tenths))
    motion_ = *motion;
  else if (const auto normal = normalOfPlane(tenths))
    normal_ = *normal;
  else
    modeBesideMotion(tenths, block);
}

void GcodeParser::modeBesideMotion(int tenths, Block& block) {
  switch (tenths) {
    case 280:
    case 300:
      block.over = block.machine = true;
      break;
    case 530:
      block.machine = true;
      break;
    case 40:
      block.dwell = true;
      break;
    case 640:
      block.blends = true;
      break;
    case 430:
    case 440:
      block.length = true;
      break;
    case 490:
      watch_.noLength();
      break;
    case 500:
      block.scaling = true;
      break;
    case 541:
      block.extended = true;
      break;
    case 200:
      unit_ = millimetresPerInch;
      watch_.unitsSaid();
      break;
    case 210:
      unit_ = 1;
      watch_.unitsSaid();
      break;
    case 900:
      absolute_ = true;
      break;
    case 910:
      absolute_ = false;
      break;
    case 901:
      absoluteCenters_ = true;
      break;
    case 911:
      absoluteCenters_ = false;
      break;
    default:
      otherMode(tenths);  // offsets, path modes and other settings do not change the contour
  }
}

void GcodeParser::otherMode(int tenths) {
  if (tenths >= 540 && tenths <= 593) return setWorkOffset(modeName(tenths));
  if (const auto obstacle = obstacleOfMode(tenths)) cannotFollow(*obstacle);
}

void GcodeParser::setWorkOffset(const std::string& name) {
  if (atWork_ && name != program_.workOffset) cannotFollow("a second work offset");
  watch_.workOffset(name, atWork_);
  program_.workOffset = name;
}

}  // namespace blossom
