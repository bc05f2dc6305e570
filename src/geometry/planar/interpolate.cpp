#include "geometry/planar/interpolate.h"

#include <Eigen/Geometry>
#include <vector>

namespace blossom {
namespace {

/// Rows lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = right[i], diagonally dominant (Thomas's algorithm).
struct Tridiagonal {
  std::vector<double> lower, diagonal, upper;

  explicit Tridiagonal(std::size_t n) : lower(n, 0), diagonal(n, 1), upper(n, 0) {}

  template <class T>
  [[nodiscard]] std::vector<T> solve(std::vector<T> right) const {
    const std::size_t n = diagonal.size();
    std::vector<double> above(n);
    double pivot = diagonal[0];
    right[0] = right[0] / pivot;
    for (std::size_t i = 1; i < n; ++i) {
      above[i - 1] = upper[i - 1] / pivot;
      pivot = diagonal[i] - lower[i] * above[i - 1];
      right[i] = (right[i] - lower[i] * right[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) right[i] -= above[i] * right[i + 1];
    return right;
  }
};

std::vector<Vec2> distinct(std::span<const Vec2> points, bool closed) {
  std::vector<Vec2> kept;
  for (const Vec2& p : points)
    if (kept.empty() || p != kept.back()) kept.push_back(p);
  while (closed && kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

/// Condition of a continuous second derivative at point i between the chords a (before) and b (after).
void smoothRow(Tridiagonal& system, std::vector<Vec2>& right, std::size_t i, double a, double b, const Vec2& before,
               const Vec2& here, const Vec2& after) {
  system.lower[i] = b;
  system.diagonal[i] = 2 * (a + b);
  system.upper[i] = a;
  right[i] = 3 * (b / a * (here - before) + a / b * (after - here));
}

std::vector<Vec2> openTangents(const std::vector<Vec2>& p, const std::vector<double>& h, std::optional<Vec2> start,
                               std::optional<Vec2> end) {
  const std::size_t n = p.size();
  Tridiagonal system(n);
  std::vector<Vec2> right(n);
  right[0] = start ? *start : Vec2(3 * (p[1] - p[0]) / h[0]);
  right[n - 1] = end ? *end : Vec2(3 * (p[n - 1] - p[n - 2]) / h[n - 2]);
  if (!start) system.diagonal[0] = 2, system.upper[0] = 1;
  if (!end) system.diagonal[n - 1] = 2, system.lower[n - 1] = 1;
  for (std::size_t i = 1; i + 1 < n; ++i) smoothRow(system, right, i, h[i - 1], h[i], p[i - 1], p[i], p[i + 1]);
  return system.solve(std::move(right));
}

/// The cyclic system is a tridiagonal one plus a matrix of rank one (Sherman & Morrison).
std::vector<Vec2> periodicTangents(const std::vector<Vec2>& p, const std::vector<double>& h) {
  const std::size_t n = p.size();
  Tridiagonal system(n);
  std::vector<Vec2> right(n);
  for (std::size_t i = 0; i < n; ++i)
    smoothRow(system, right, i, h[(i + n - 1) % n], h[i], p[(i + n - 1) % n], p[i], p[(i + 1) % n]);
  const double topRight = system.lower[0], bottomLeft = system.upper[n - 1], gamma = -system.diagonal[0];
  system.diagonal[0] -= gamma;
  system.diagonal[n - 1] -= topRight * bottomLeft / gamma;
  std::vector<double> corner(n, 0);
  corner[0] = gamma;
  corner[n - 1] = bottomLeft;
  const std::vector<double> z = system.solve(std::move(corner));
  std::vector<Vec2> y = system.solve(std::move(right));
  const double ratio = topRight / gamma;
  const Vec2 factor = (y[0] + ratio * y[n - 1]) / (1 + z[0] + ratio * z[n - 1]);
  for (std::size_t i = 0; i < n; ++i) y[i] -= z[i] * factor;
  return y;
}

}  // namespace

std::optional<Spline2> interpolated(std::span<const Vec2> points, bool closed, const std::optional<Vec2>& startTangent,
                                    const std::optional<Vec2>& endTangent) {
  std::vector<Vec2> p = distinct(points, closed);
  if (p.size() < 2) return {};
  if (p.size() < 3) closed = false;
  const std::size_t n = p.size(), spans = closed ? n : n - 1;
  std::vector<double> h(spans);
  for (std::size_t i = 0; i < spans; ++i) h[i] = (p[(i + 1) % n] - p[i]).norm();
  const std::vector<Vec2> m = closed ? periodicTangents(p, h) : openTangents(p, h, startTangent, endTangent);

  Spline2 spline{3, {0, 0, 0, 0}, {p[0].homogeneous()}};
  double t = 0;
  for (std::size_t i = 0; i < spans; ++i) {
    const std::size_t next = (i + 1) % n;
    spline.poles.push_back(Vec2(p[i] + h[i] / 3 * m[i]).homogeneous());
    spline.poles.push_back(Vec2(p[next] - h[i] / 3 * m[next]).homogeneous());
    spline.poles.push_back(p[next].homogeneous());
    t += h[i];
    spline.knots.insert(spline.knots.end(), 3, t);
  }
  spline.knots.push_back(t);
  return spline;
}

}  // namespace blossom
