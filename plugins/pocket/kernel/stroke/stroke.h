#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// A line or circular arc in the plane, as a path of the tool's centre or a piece of a wall. mm, radians.
struct Stroke {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  bool round = false;
  Vec2 center = Vec2::Zero();
  double radius = 0, start = 0, sweep = 0;  ///< of an arc, as in Arc2

  static Stroke line(const Vec2& from, const Vec2& to);
  static Stroke arc(const Vec2& center, double radius, double start, double sweep);

  [[nodiscard]] double length() const;
  /// The point, and the unit direction, at a fraction 0..1 of the length.
  [[nodiscard]] Vec2 at(double share) const;
  [[nodiscard]] Vec2 direction(double share) const;
  /// The part between two fractions of the length; reversed when `last` is below `first`.
  [[nodiscard]] Stroke part(double first, double last) const;
  [[nodiscard]] Stroke reversed() const { return part(1, 0); }
  /// Corners of its box.
  [[nodiscard]] std::pair<Vec2, Vec2> box() const;
  /// The fraction of the length of the point nearest to p.
  [[nodiscard]] double nearestShare(const Vec2& p) const;
};

/// The share of the way from `a` to `b` at which a straight line is nearest to x.
inline double nearestShare(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp((x - a).dot(along) / squared, 0.0, 1.0) : 0;
}

double distance(const Stroke&, const Vec2&);
/// Minimum distance of two strokes, in closed form; 0 when they meet. The candidates are the four ends, the crossings of the
/// strokes, and the pairs of inner points whose connection is normal to both.
double distance(const Stroke&, const Stroke&);

/// The segments of a path; splines as lines within `chord` mm. Each begins exactly where the one before ends.
std::vector<Stroke> strokesOf(const Path&, double chord);

}  // namespace blossom::pocket
