#pragma once
#include <optional>
#include <span>

#include "kernel/grid.h"

namespace blossom::minkowski {

/// A convex polygon in the interior of a set.
class ConvexCore {
 public:
  /// @param corners counter-clockwise, at least three
  explicit ConvexCore(GridLoop corners);

  [[nodiscard]] const GridLoop& corners() const { return corners_; }
  [[nodiscard]] const GridPoint& centre() const { return centre_; }
  /// Whether a point lies well inside.
  [[nodiscard]] bool contains(const GridPoint& p) const {
    const double x = static_cast<double>(p.x - centre_.x), y = static_cast<double>(p.y - centre_.y);
    const double squared = x * x + y * y;
    if (squared <= inner_) return true;
    if (squared >= outer_) return false;
    for (const Side& side : sides_)
      if (side.x * x + side.y * y > side.reach) return false;
    return true;
  }

 private:
  struct Side {
    double x, y, reach;
  };
  GridLoop corners_;
  GridPoint centre_;
  std::vector<Side> sides_;
  double inner_ = 0, outer_ = 0;  ///< squared radii of circles about the centre, inside and around
};

/// A convex polygon of few corners in the interior of A + B, large when both are nearly convex: a scaled hull of a part of
/// A, added to one of B or moved by a point of it. Nothing when there is hardly any, or when the
/// sets have so few corners that it is not worth the time. O(n).
std::optional<ConvexCore> coreOfSum(std::span<const GridPolygon> a, std::span<const GridPolygon> b);

}  // namespace blossom::minkowski
