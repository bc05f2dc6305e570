#include "pocket_place.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/units.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/shape.h"
#include "toolpath_place.h"

namespace blossom::pocket {

namespace {

/// The stock around the part, or around the solid whose face it is; the path begins to cut at z = 0.
Bounds stockOf(const PocketParameters& p, const Region& region, const PocketHeights& heights) {
  auto [low, high] = boxOf(region);
  constexpr double below = 2;  // mm left under the pocket when nothing is said
  double bottom = -heights.depth - below;
  if (!heights.box.empty) {
    low = low.cwiseMin(heights.box.low.head<2>());
    high = high.cwiseMax(heights.box.high.head<2>());
    bottom = std::min(heights.bottom, -heights.depth);
  }
  if (p.stockThickness > 0) bottom = heights.above - p.stockThickness;
  if (bottom > -heights.depth)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The stock is {} mm thick, and the pocket would be {} mm deep.", formatNumber(p.stockThickness),
                            formatNumber(heights.above + heights.depth)),
                "Use thicker stock, or 0 for as thick as needed.");
  Bounds stock;
  stock.add({low.x() - p.stockMargin, low.y() - p.stockMargin, bottom});
  stock.add({high.x() + p.stockMargin, high.y() + p.stockMargin, heights.above});
  return stock;
}

/// From where the path begins to cut at z = 0 to where the work has its zero.
Vec3 toWorkZero(const PocketParameters& p, const Part& part, const PocketHeights& heights, const Bounds& stock) {
  Vec3 by = -zeroOf(p.zero, p.zeroHeight, stock);
  if (p.zero == Zero::Drawing && p.zeroHeight == ZeroHeight::Top && part.looksUp)
    by.z() = part.height - heights.face;  // a face keeps its height
  return by;
}

/// Moves the z = 0 from which a pocket is cut up by a length.
void raise(PocketHeights& heights, double by) {
  heights.depth += by;
  heights.face -= by;
  heights.bottom -= by;
  if (!heights.box.empty) {
    heights.box.low.z() -= by;
    heights.box.high.z() -= by;
  }
  for (auto& triangle : heights.triangles)
    for (Vec3& corner : triangle) corner.z() -= by;
}

}  // namespace

std::optional<Vec3> planeIn(const Setup& setup, const Part& part) {
  const gp_Trsf inSetup = setup.drawing.Inverted() * part.placing;
  constexpr double straight = 1e-9;
  double turned = 0;
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 3; ++column)
      turned = std::max(turned, std::abs(inSetup.Value(row, column) - (row == column ? 1 : 0)));
  if (turned > straight) return std::nullopt;
  const gp_XYZ at = inSetup.TranslationPart();
  return Vec3(at.X(), at.Y(), at.Z());
}

PocketPlace placeOfItsOwn(const PocketParameters& p, const Part& part, const PocketHeights& heights) {
  const Bounds stock = stockOf(p, part.region, heights);
  return {stock, toWorkZero(p, part, heights, stock)};
}

PocketPlace placeInSetup(const Setup& setup, const Part& part, PocketHeights& heights) {
  const auto plane = planeIn(setup, part);
  if (!plane)
    throw Error(ErrorCode::InvalidInput, "The part does not look up in this setup.",
                "Choose a face that looks up there, or make a setup with this face up.");
  Vec3 toWork = *plane - Vec3(0, 0, heights.face);
  Bounds stock, all;
  for (const Shape& each : setup.stock) stock.add(bounds(each));
  all.add(bounds(setup));
  const double above = stock.high.z() - toWork.z();
  if (above > 0) {
    raise(heights, above);
    toWork.z() += above;
  }
  heights.above = std::max(0.0, all.high.z() - toWork.z());
  stock.low -= toWork;
  stock.high -= toWork;
  return {stock, toWork};
}

}  // namespace blossom::pocket
