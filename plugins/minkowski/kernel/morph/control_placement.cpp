#include "kernel/morph/control_placement.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "kernel/morph/control_centre.h"

namespace blossom::minkowski {
namespace {

/// Sine and cosine of 90 degrees are not 0 and 1 in radians, so quarters are turned apart from the rest.
Eigen::Matrix2d rotation(double degrees) {
  const double quarters = std::round(degrees / 90), rest = (degrees - 90 * quarters) * std::numbers::pi / 180;
  const Vec2 along(std::cos(rest), std::sin(rest)), across(-along.y(), along.x());
  Eigen::Matrix2d turned;
  switch (static_cast<int>(std::remainder(quarters, 4.0))) {
    case 0:
      turned << along, across;
      break;
    case 1:
      turned << across, -along;
      break;
    case -1:
      turned << -across, along;
      break;
    default:  // 2 or -2
      turned << -along, -across;
  }
  return turned;
}

}  // namespace

Eigen::Matrix<double, 2, 3> affineOf(const Placement& placement, const Vec2& centre) {
  const Eigen::Matrix2d linear = placement.scale * rotation(placement.turn);
  Eigen::Matrix<double, 2, 3> affine;
  affine << linear, Vec2(placement.offset + (centre - linear * centre));
  return affine;
}

Region placed(const Region& region, const Placement& placement) {
  if (placement == Placement()) return region;
  if (!(placement.scale > 0) || !std::isfinite(placement.scale))
    throw Error(ErrorCode::InvalidParameter, fmt::format("A scale must be above 0; it is {}.", placement.scale));
  if (!std::isfinite(placement.turn) || !placement.offset.allFinite())
    throw Error(ErrorCode::InvalidParameter, "A turn or an offset of a control shape is not a finite number.");
  const bool onlyMoved = placement.scale == 1 && std::remainder(placement.turn, 360) == 0;
  const auto affine = affineOf(placement, onlyMoved ? Vec2(Vec2::Zero()) : centreOf(region));
  Region result = region;
  for (Path& loop : result.loops) loop = transformed(loop, affine);
  return result;
}

}  // namespace blossom::minkowski
