#include "kernel/begin/turning_spline.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/angle.h"
#include "geometry/bspline/bspline.h"
#include "geometry/bspline/product.h"
#include "geometry/shape/motion.h"

namespace blossom::sweep {

using std::numbers::pi;

std::vector<double> evenBreaks(std::size_t n) {
  std::vector<double> breaks;
  for (std::size_t i = 0; i <= n; ++i) breaks.push_back(static_cast<double>(i) / static_cast<double>(n));
  return breaks;
}

std::vector<double> clampedKnots(int degree, const std::vector<double>& breaks) {
  std::vector<double> knots(static_cast<std::size_t>(degree), breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), static_cast<std::size_t>(degree), breaks.back());
  return knots;
}

std::vector<double> grevilleAbscissae(int degree, const std::vector<double>& knots) {
  std::vector<double> result;
  for (std::size_t i = 1; i + static_cast<std::size_t>(degree) < knots.size(); ++i) {
    const auto first = knots.begin() + static_cast<std::ptrdiff_t>(i);
    result.push_back(std::accumulate(first, first + degree, 0.0) / degree);
  }
  return result;
}

std::vector<double> closedTurn(std::size_t n, double start) {
  std::vector<double> halves;
  // Pole i of a cubic stands over break i - 1.
  for (std::size_t i = 0; i < n; ++i)
    halves.push_back(start / 2 + pi * (static_cast<double>(i) - 1) / static_cast<double>(n));
  return halves;
}

Curve openTurn(std::size_t n, double from, double to) {
  const double spans = static_cast<double>(n);
  Curve curve{3, {}, {}};
  for (std::size_t i = 0; i < n + 7; ++i) curve.knots.push_back((static_cast<double>(i) - 3) / spans);
  for (std::size_t i = 0; i < n + 3; ++i) {
    const double half = (from + (to - from) * (static_cast<double>(i) - 1) / spans) / 2;
    curve.poles.emplace_back(std::cos(half), 0, 0, std::sin(half));
  }
  curve.knots[3] = 0, curve.knots[n + 3] = 1;
  return clamped(curve);
}

Curve circleInStep(const Curve& turn, double radius) {
  Curve a = turn, b = turn;
  for (std::size_t i = 0; i < turn.poles.size(); ++i) {
    const double w = turn.poles[i][0], z = turn.poles[i][3];
    a.poles[i] = {w, w, 0, z};
    b.poles[i] = {w, z, 0, z};
  }
  Curve circle = product(a, b);  // w^2, w z, 0, z^2
  for (Vec4& pole : circle.poles) pole = Vec4(radius * (pole[0] - pole[3]), 2 * radius * pole[1], 0, pole[0] + pole[3]);
  return circle;
}

Curve straightLine(std::size_t n, const Vec3& from, const Vec3& to) {
  Curve curve{3, clampedKnots(3, evenBreaks(n)), {}};
  for (const double t : grevilleAbscissae(3, curve.knots)) {
    const Vec3 p = from + t * (to - from);
    curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  }
  return curve;
}

ClosedTurn::ClosedTurn(std::size_t n, double start) : start_(start), spline_{3, unwrappedKnots(3, evenBreaks(n)), {}} {
  const std::vector<double> halves = closedTurn(n, start);
  for (std::size_t i = 0; i < n + 3; ++i) {
    const double half = halves[i % n] + (i < n ? 0 : pi);
    spline_.poles.emplace_back(std::cos(half), std::sin(half), 0, 1);
  }
}

ClosedTurn::Angle ClosedTurn::at(double u) const {
  const std::vector<Vec4> d = derivatives(spline_, u, 1);
  const double x = d[0].x(), y = d[0].y(), square = x * x + y * y;
  const double slope = 2 * (x * d[1].y() - y * d[1].x()) / square;
  // The branch of the angle that is near the constant speed: the two differ by less than a step.
  const double rough = start_ + fullTurn * u, angle = 2 * std::atan2(y, x);
  return {angle + fullTurn * std::round((rough - angle) / fullTurn), slope};
}

double ClosedTurn::parameterOf(double value) const {
  double u = (value - start_) / fullTurn;
  // The speed is nearly constant: Newton's method gains digits from the first step on.
  for (int step = 0; step < 8; ++step) {
    const Angle angle = at(std::min(std::max(u, 0.0), 1.0));
    u = std::min(std::max(u - (angle.value - value) / angle.slope, 0.0), 1.0);
  }
  return u;
}

}  // namespace blossom::sweep
