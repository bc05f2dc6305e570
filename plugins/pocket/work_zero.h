#pragma once
#include "core/vector.h"
#include "geometry/values/box.h"

namespace blossom::pocket {

/// The work's zero: that of the drawing, or the stock's lower left corner or centre.
enum class Zero { Drawing, Corner, Center };
/// Its height: the stock's top or bottom, or that of the drawing.
enum class ZeroHeight { Top, Bottom, Drawing };

/// The place of the work's zero in the coordinates of the stock. @param drawing the place of the drawing's zero
inline Vec3 zeroOf(Zero zero, ZeroHeight height, const Bounds& stock, const Vec3& drawing = Vec3::Zero()) {
  Vec3 at = drawing;
  if (zero == Zero::Corner) at.head<2>() = stock.low.head<2>();
  if (zero == Zero::Center) at.head<2>() = stock.center().head<2>();
  if (height == ZeroHeight::Top) at.z() = stock.high.z();
  if (height == ZeroHeight::Bottom) at.z() = stock.low.z();
  return at;
}

}  // namespace blossom::pocket
