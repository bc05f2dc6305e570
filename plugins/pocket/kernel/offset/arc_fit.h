#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// A point of a curve with its unit tangent.
struct TangentPoint {
  Vec2 at, tangent;
};

/// A quarter turn counter-clockwise.
inline Vec2 toTheLeft(const Vec2& v) { return {-v.y(), v.x()}; }

/// The arc from a to b that sweeps `sweep` radians (a line when the sweep is close to 0).
Segment arcBetween(const Vec2& a, const Vec2& b, double sweep);

/// An arc or a line by its ends and its direction at the first one, as fits ask it. Angles wait until it is taken.
class Bow {
 public:
  Bow() = default;
  /// @param tangent of length 1
  Bow(const Vec2& from, const Vec2& tangent, const Vec2& to);
  static Bow straight(const Vec2& from, const Vec2& to) { return {from, (to - from).normalized(), to}; }

  [[nodiscard]] const Vec2& from() const { return from_; }
  [[nodiscard]] const Vec2& tangent() const { return tangent_; }
  [[nodiscard]] const Vec2& endTangent() const { return endTangent_; }
  [[nodiscard]] bool isOverHalfATurn() const { return turn_.x() < 0; }
  [[nodiscard]] Segment segment() const { return arcBetween(from_, to_, sweep()); }
  [[nodiscard]] double length() const;
  [[nodiscard]] bool isBehindEnd(const Vec2& p) const { return (p - to_).dot(endTangent_) <= 0; }
  [[nodiscard]] bool isWithin(const Vec2& p, double distance) const;

 private:
  [[nodiscard]] double sweep() const;

  Vec2 from_ = Vec2::Zero(), to_ = Vec2::Zero(), tangent_ = Vec2::Zero(), endTangent_ = Vec2::Zero();
  Vec2 turn_ = Vec2::Zero();  ///< from the tangent to the chord: a multiple of cosine and sine
  double curvature_ = 0;
};

/// One or two of them that meet smoothly, or none from a point to itself.
struct Biarc {
  std::array<Bow, 2> bows;
  std::size_t count = 0;

  [[nodiscard]] double length() const;
  [[nodiscard]] bool isOverHalfATurn() const;  ///< one of them is
  [[nodiscard]] bool isWithin(const Vec2& p, double distance) const;
};

/// Between two points of a curve, along their tangents where possible, else the line (Bolton, "Biarc curves", CAD 7(2),
/// 1975; the joint with equal control lengths). One arc where that leaves the second tangent by less than `within` mm.
Biarc biarcBetween(const TangentPoint& a, const TangentPoint& b, double within = 0);

/// An end of a fitted arc: a sample, or between two of them.
struct FitJoint {
  TangentPoint place;
  std::size_t sample = 0;  ///< the last one before or at it
  bool isSample = true;
};
/// The ends of lines and arcs from the first sample to the last, within `tolerance` mm of all samples: of biarcs through as
/// few samples as possible. O(n log n).
std::vector<FitJoint> fittedJoints(const std::vector<TangentPoint>& samples, double tolerance);

}  // namespace blossom::pocket
