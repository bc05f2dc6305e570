#pragma once
#include <array>
#include <span>
#include <variant>

#include "core/vector.h"

namespace blossom::minkowski {

/// A straight line through two different points.
struct StraightCurve {
  Vec2 from, to;
};

struct Circle {
  Vec2 centre;
  double radius = 0;  ///< above 0
};

/// The curve that an edge of a convolution stands for.
using TrueCurve = std::variant<StraightCurve, Circle>;

/// The point of the curve nearest to p.
Vec2 nearestOn(const TrueCurve&, const Vec2& p);
/// Whether two curves lie within a distance of each other: of lines between their given points, of circles all around.
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
/// Lines that are parallel and circles about one centre do not meet.
Meetings meetingsOf(const TrueCurve&, const TrueCurve&, double touching);

}  // namespace blossom::minkowski
