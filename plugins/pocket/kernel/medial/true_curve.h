#pragma once
#include <variant>
#include <vector>

#include "core/vector.h"
#include "geometry/planar/planar_bezier.h"
#include "geometry/planar/region.h"

namespace blossom::pocket {

/// A smooth piece of a boundary as drawn: a line, an arc or a rational Bézier piece, over [0, 1].
class TrueCurve {
 public:
  explicit TrueCurve(Line2);
  explicit TrueCurve(Arc2);
  explicit TrueCurve(BezierPiece);

  struct Frame {
    Vec2 point, first, second;  ///< with respect to the parameter
  };
  [[nodiscard]] Frame at(double t) const;
  [[nodiscard]] Vec2 point(double t) const { return at(t).point; }
  struct Place {
    Vec2 point;
    Vec2 tangent;          ///< of length 1; at an end where the derivative vanishes, the limit
    double curvature = 0;  ///< 1 / mm, positive when the curve bends to the left; 0 where the derivative vanishes
  };
  [[nodiscard]] Place placeAt(double t) const;
  [[nodiscard]] Vec2 tangent(double t) const { return placeAt(t).tangent; }
  [[nodiscard]] double curvature(double t) const { return placeAt(t).curvature; }

  /// Parameter of the foot of the perpendicular from `x` found by Newton's iteration from `guess`. It may leave [0, 1] by
  /// `margin`, so that a foot slightly beyond an end because of rounding is accepted.
  [[nodiscard]] double foot(const Vec2& x, double guess, double margin) const;

  [[nodiscard]] const Line2* line() const { return std::get_if<Line2>(&value_); }
  [[nodiscard]] const Arc2* arc() const { return std::get_if<Arc2>(&value_); }
  /// mm, upper bound of the arc length.
  [[nodiscard]] double lengthBound() const { return length_; }

 private:
  std::variant<Line2, Arc2, BezierPiece> value_;
  double length_ = 0;
};

/// The smooth pieces of a segment: one, or a spline's Bézier pieces.
std::vector<TrueCurve> trueCurves(const Segment&);

struct CurveSample {
  double parameter = 0;
  Vec2 point;
};

/// Points along the curve with chords within `chord` mm of it and small angles between consecutive chords; both ends
/// included.
std::vector<CurveSample> flattened(const TrueCurve&, double chord);

}  // namespace blossom::pocket
