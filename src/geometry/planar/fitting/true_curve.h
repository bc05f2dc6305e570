#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// A straight line through two different points.
struct StraightCurve {
  Vec2 from, to;
};

struct Circle {
  Vec2 centre;
  double radius = 0;  ///< above 0
};

/// A point of a free-form curve, or of a polygon beside it.
struct FreePoint {
  Vec2 at;
  double normal = 0;      ///< angle of the normal, on the side away from the material
  bool isOnCurve = true;  ///< false where only the polygon passes
};

/// A short side that stands for part of a free-form curve. Sides of one curve have one name: what is moved and what it is
/// moved by, of the first and of the second set.
struct FreeSide {
  std::array<std::uint64_t, 2> name{};
  FreePoint from, to;
  std::optional<FreePoint> between = {};  ///< of the curve itself, where its ends are not
};

/// The curve that an edge of a convolution stands for.
using TrueCurve = std::variant<StraightCurve, Circle, FreeSide>;

/// On which a line or an arc lies. @pre not a spline
TrueCurve trueCurveOf(const Segment&);

bool isFree(const TrueCurve&);
/// The point of the curve nearest to p; of a free side p itself.
Vec2 nearestOn(const TrueCurve&, const Vec2& p);
/// Whether two curves lie within a distance of each other: of lines between their given points, of circles all around. Free
/// sides are not compared.
bool sameCurve(const TrueCurve&, const TrueCurve&, double within);

/// At most two points.
class Meetings {
 public:
  void add(const Vec2& p) { at_.at(count_++) = p; }
  [[nodiscard]] std::span<const Vec2> points() const { return {at_.data(), count_}; }

 private:
  std::array<Vec2, 2> at_{};
  std::size_t count_ = 0;
};

/// Where two curves meet. Curves that miss each other by at most `touching`, or overlap by no more, touch in one point.
/// Lines that are parallel, circles about one centre and free sides do not meet.
Meetings meetingsOf(const TrueCurve&, const TrueCurve&, double touching);

}  // namespace blossom::planar
