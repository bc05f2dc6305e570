#include "kernel/grid/motion_point.h"

#include <array>

namespace blossom::sweep {

namespace {

/// A function of (u, v) known up to its mixed derivative; sums and products follow the rules of differentiation.
struct Jet {
  double f = 0, u = 0, v = 0, uv = 0;
};
Jet operator+(const Jet& a, const Jet& b) { return {a.f + b.f, a.u + b.u, a.v + b.v, a.uv + b.uv}; }
Jet operator-(const Jet& a, const Jet& b) { return {a.f - b.f, a.u - b.u, a.v - b.v, a.uv - b.uv}; }
Jet operator*(double k, const Jet& a) { return {k * a.f, k * a.u, k * a.v, k * a.uv}; }
Jet operator*(const Jet& a, const Jet& b) {
  return {a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v, a.uv * b.f + a.u * b.v + a.v * b.u + a.f * b.uv};
}
Jet operator/(const Jet& a, const Jet& b) {
  const double k = 1 / b.f;
  const Jet inverse{k, -k * k * b.u, -k * k * b.v, k * k * (2 * k * b.u * b.v - b.uv)};
  return a * inverse;
}

using Jet4 = std::array<Jet, 4>;

Jet4 evaluateSurface(const Surface& surface, double u, double v, KnotSide sideU, KnotSide sideV) {
  const BasisTable bu = tabulateBasis(surface.degreeU, surface.knotsU, {&u, 1}, sideU);
  const BasisTable bv = tabulateBasis(surface.degreeV, surface.knotsV, {&v, 1}, sideV);
  Jet4 result;
  for (std::size_t i = 0; i < bu.value.size(); ++i)
    for (std::size_t j = 0; j < bv.value.size(); ++j) {
      const Vec4& pole = surface.pole(bu.first[0] + i, bv.first[0] + j);
      const Jet weight{bu.value[i] * bv.value[j], bu.derivative[i] * bv.value[j], bu.value[i] * bv.derivative[j],
                       bu.derivative[i] * bv.derivative[j]};
      for (std::size_t c = 0; c < 4; ++c) result[c] = result[c] + pole[static_cast<Eigen::Index>(c)] * weight;
    }
  return result;
}

Jet4 evaluateCurve(const Curve& curve, double v, KnotSide side) {
  const BasisTable basis = tabulateBasis(curve.degree, curve.knots, {&v, 1}, side);
  Jet4 result;
  for (std::size_t j = 0; j < basis.value.size(); ++j)
    for (std::size_t c = 0; c < 4; ++c) {
      const double pole = curve.poles[basis.first[0] + j][static_cast<Eigen::Index>(c)];
      result[c] = result[c] + Jet{pole * basis.value[j], 0, pole * basis.derivative[j], 0};
    }
  return result;
}

}  // namespace

MotionPoint evaluate(const Motion& motion, double u, double v, KnotSide sideU, KnotSide sideV) {
  const Jet4 t = evaluateCurve(motion.trajectory, v, sideV);
  const auto [w, x, y, z] = evaluateSurface(motion.orientation, u, v, sideU, sideV);
  const auto [sx, sy, sz, sw] = evaluateSurface(motion.scaling, u, v, sideU, sideV);
  const Jet ax = motion.point.x() * sx, ay = motion.point.y() * sy, az = motion.point.z() * sz;
  const Jet d = w * w + x * x + y * y + z * z;
  const std::array<Jet, 3> turned = {
      (w * w + x * x - y * y - z * z) * ax + 2.0 * ((x * y - w * z) * ay + (x * z + w * y) * az),
      (w * w - x * x + y * y - z * z) * ay + 2.0 * ((x * y + w * z) * ax + (y * z - w * x) * az),
      (w * w - x * x - y * y + z * z) * az + 2.0 * ((x * z - w * y) * ax + (y * z + w * x) * ay)};
  MotionPoint result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Jet position = t[c] / t[3] + turned[c] / (d * sw);
    const auto k = static_cast<Eigen::Index>(c);
    result.point[k] = position.f, result.du[k] = position.u, result.dv[k] = position.v, result.duv[k] = position.uv;
  }
  result.weight = t[3].f * d.f * sw.f;
  return result;
}

}  // namespace blossom::sweep
