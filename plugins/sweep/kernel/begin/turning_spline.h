#pragma once
#include <cstddef>
#include <vector>

#include "geometry/bspline/curve.h"

/// Cubic splines around the origin whose direction is a half-angle. As quaternions (cos, 0, 0, sin) of any length they turn
/// points on exact circles, because d = |r|^2 divides out; only the speed is not quite constant.
namespace blossom::sweep {

/// 0, 1/n .. 1.
std::vector<double> evenBreaks(std::size_t n);
/// Clamped full vector from breaks.
std::vector<double> clampedKnots(int degree, const std::vector<double>& breaks);
/// The mean of `degree` consecutive knots for each pole: a spline whose poles are linear in these is linear.
std::vector<double> grevilleAbscissae(int degree, const std::vector<double>& knots);

/// The n rows of poles, as half-angles in radians, of one full turn that closes anti-periodically over n even spans; the
/// value at 0 has the half-angle of `start` / 2.
std::vector<double> closedTurn(std::size_t n, double start = 0);

/// Clamped quaternions over n even spans of 0..1 whose turn about z runs from one angle to the other, in radians, exactly
/// at both ends. Needs steps of less than a full turn.
Curve openTurn(std::size_t n, double from, double to);

/// Circle about z in the plane z = 0 that keeps step with the turns of `turn`: radius c^2 / |c|^2 for c = w + i z, of twice
/// its degree.
Curve circleInStep(const Curve& turn, double radius);

/// Straight cubic over n even spans of 0..1, at constant speed.
Curve straightLine(std::size_t n, const Vec3& from, const Vec3& to);

/// The angle 2 arg(c) of a closed turn at u and its derivative.
class ClosedTurn {
 public:
  explicit ClosedTurn(std::size_t n, double start = 0);

  struct Angle {
    double value = 0, slope = 0;
  };
  /// Radians, `start` at 0 and one full turn more at 1, increasing.
  [[nodiscard]] Angle at(double u) const;
  /// The parameter where the angle is `value`, from `start` to one full turn more.
  [[nodiscard]] double parameterOf(double value) const;

 private:
  double start_;
  Curve spline_;
};

}  // namespace blossom::sweep
