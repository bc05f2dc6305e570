#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/curve.h"

namespace blossom::sweep {

/// A point of a curve in R^3 with its first and second derivatives by the parameter.
struct CurvePoint {
  Vec3 point, first, second;

  [[nodiscard]] Vec3 tangent() const { return first.normalized(); }
  /// Angular velocity of the tangent, c' x c'' / |c'|^2: that of a rotation-minimising frame, which has no part along the
  /// tangent (Wang, Juettler, Zheng & Liu 2008, section 3).
  [[nodiscard]] Vec3 turning() const { return first.cross(second) / first.squaredNorm(); }
};

/// A curve that has a tangent everywhere, ready to carry frames.
class SmoothCurve {
 public:
  /// Angle in radians from which two tangents that meet are a corner.
  static constexpr double corner = 1e-4;

  /// Its parameters are mapped to 0..1 and its knots clamped; the points stay the same.
  /// @throws Error InvalidInput for a weight that is not positive or a corner, Degenerate for a cusp, where the derivative
  /// vanishes; both name the parameter (0..1) and the place. O(poles), longer near a cusp.
  explicit SmoothCurve(const Curve&);

  [[nodiscard]] const Curve& curve() const { return curve_; }
  /// The distinct knots, 0 first and 1 last.
  [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }
  /// Whether its ends meet within 1e-9 of its size, without a corner.
  [[nodiscard]] bool closed() const { return closed_; }
  /// Radians between its tangents where its ends meet; 0 where they do not.
  [[nodiscard]] double cornerAtEnds() const { return cornerAtEnds_; }
  /// Diagonal of the box around its poles.
  [[nodiscard]] double size() const { return size_; }

  [[nodiscard]] std::size_t pieceOf(double t) const;
  /// By the polynomial piece given, which at a break decides the side.
  [[nodiscard]] CurvePoint at(double t, std::size_t piece) const;
  [[nodiscard]] CurvePoint at(double t) const { return at(t, pieceOf(t)); }
  /// Multiplicity of a cubic knot at break k that follows the turning of the frames: 3 where it jumps, 2 where only its
  /// derivative may, 1 where neither does.
  [[nodiscard]] int frameMultiplicity(std::size_t k) const;
  [[nodiscard]] double length(double from, double to) const;

 private:
  void refuseCusps() const;
  void refuseCorners() const;

  Curve curve_;
  std::vector<double> breaks_;
  std::vector<Curve> pieces_;
  bool closed_ = false;
  double cornerAtEnds_ = 0;
  double size_ = 0;
};

}  // namespace blossom::sweep
