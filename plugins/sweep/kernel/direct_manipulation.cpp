#include "kernel/direct_manipulation.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/basis_table.h"

namespace blossom::sweep {

namespace {

/// How much each free row weighs at a parameter, with the sign of the periods passed. When fewer rows are free than basis
/// functions overlap, several of them stand for the same row and add up.
std::vector<double> sharesOfRows(const BasisTable& u, std::size_t free, double sign) {
  std::vector<double> shares(free, 0.0);
  for (std::size_t i = 0; i < u.value.size(); ++i) {
    std::size_t row = u.first[0] + i;
    double share = u.value[i];
    for (; row >= free; row -= free) share *= sign;
    shares[row] += share;
  }
  return shares;
}

/// Changes the value of a factor at (u, v) by `delta` with the smallest change of its poles.
/// @param sign of the rows that repeat the first ones; 0: not closed
void changeAt(Surface& factor, double u, double v, const Vec4& delta, double sign) {
  const BasisTable bu = tabulateBasis(factor.degreeU, factor.knotsU, {&u, 1}),
                   bv = tabulateBasis(factor.degreeV, factor.knotsV, {&v, 1});
  const std::size_t repeated = sign == 0 ? 0 : static_cast<std::size_t>(factor.degreeU), free = factor.countU() - repeated;
  const std::vector<double> rows = sharesOfRows(bu, free, sign);
  double square = 0;
  for (const double a : rows)
    for (const double b : bv.value) square += a * a * b * b;
  if (!(square > 0))
    throw Error(
        ErrorCode::Degenerate,
        fmt::format("The turns around this closed motion cancel each other at u = {}: no change of its poles reaches "
                    "that place.",
                    u),
        "Give the motion more poles in u.");
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; rows[i] != 0 && j < bv.value.size(); ++j)
      factor.pole(i, bv.first[0] + j) += rows[i] * bv.value[j] / square * delta;
  for (std::size_t i = 0; i < repeated; ++i)
    for (std::size_t j = 0; j < factor.countV(); ++j) factor.pole(free + i, j) = sign * factor.pole(i, j);
}

/// The vector a turned back by the quaternion q of any length: Q(q)^T a / |q|^2.
Vec3 turnedBack(const Vec4& q, const Vec3& a) {
  const Vec3 axis = q.tail<3>();
  const Vec3 turned = (q[0] * q[0] - axis.squaredNorm()) * a + 2 * axis.dot(a) * axis - 2 * q[0] * axis.cross(a);
  return turned / q.squaredNorm();
}

Vec4 times(const Vec4& a, const Vec4& b) {
  const Vec3 x = a.tail<3>(), y = b.tail<3>(), z = a[0] * y + b[0] * x + x.cross(y);
  return {a[0] * b[0] - x.dot(y), z.x(), z.y(), z.z()};
}

double signOfScaling(const Motion& motion) { return motion.closedU == ClosedU::No ? 0 : 1; }
double signOfOrientation(const Motion& motion) {
  return motion.closedU == ClosedU::No ? 0 : motion.closedU == ClosedU::AntiPeriodic ? -1 : 1;
}

}  // namespace

void dragScaling(Motion& motion, double u, double v, const Vec3& to) {
  const Vec4 s = evaluate(motion.scaling, u, v);
  const Vec3 wanted = turnedBack(evaluate(motion.orientation, u, v), to - point(motion.trajectory, v));
  Vec4 delta = Vec4::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (motion.point[k] != 0) {
      delta[k] = s[3] * wanted[k] / motion.point[k] - s[k];
    } else if (std::abs(wanted[k]) > 1e-9 * (1 + wanted.norm())) {
      throw Error(ErrorCode::InvalidParameter,
                  "Scaling alone cannot reach that place: the swept point lies in a coordinate plane of the moving frame.",
                  "Drag within that plane, or turn the frame first.");
    }
  }
  changeAt(motion.scaling, u, v, delta, signOfScaling(motion));
}

void twistOrientation(Motion& motion, double u, double v, const Vec3& axis, double degrees) {
  if (!(axis.norm() > 0)) throw Error(ErrorCode::InvalidParameter, "An axis to twist about needs a length.");
  const double half = degrees * std::numbers::pi / 360;
  const Vec3 w = std::sin(half) * axis.normalized();
  const Vec4 r = evaluate(motion.orientation, u, v);
  // Not normalised: q' - q of unit quaternions would miss unless |r| = 1.
  changeAt(motion.orientation, u, v, times({std::cos(half), w.x(), w.y(), w.z()}, r) - r, signOfOrientation(motion));
}

}  // namespace blossom::sweep
