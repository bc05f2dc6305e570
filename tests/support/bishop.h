#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <vector>

#include "core/vector.h"

/// Rotation-minimising frames by integrating their differential equation, independently of the double reflection.
namespace blossom::test {

/// Unit tangent and its derivative by the parameter.
struct TangentAt {
  Vec3 tangent, slope;
};

/// The normal carried from one parameter to another: r' = -(r . t') t (Bishop 1975), by Runge and Kutta's method of order 4.
inline Vec3 bishopNormal(const std::function<TangentAt(double)>& curve, Vec3 normal, double from, double to, int steps) {
  const double h = (to - from) / steps;
  const auto slope = [](const TangentAt& at, const Vec3& r) { return Vec3(-r.dot(at.slope) * at.tangent); };
  for (int k = 0; k < steps; ++k) {
    const double t = from + k * h;
    const TangentAt start = curve(t), middle = curve(t + h / 2), end = curve(t + h);
    const Vec3 k1 = slope(start, normal), k2 = slope(middle, normal + h / 2 * k1), k3 = slope(middle, normal + h / 2 * k2),
               k4 = slope(end, normal + h * k3);
    normal += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    normal = (normal - end.tangent.dot(normal) * end.tangent).normalized();
  }
  return normal;
}

}  // namespace blossom::test
