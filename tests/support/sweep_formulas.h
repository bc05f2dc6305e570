#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/shape/motion.h"

/// Direct manipulation of a two-parameter motion by the formulas of the paper (Yoon & Lee 2009, section 4), with basis
/// functions, rotations and rows of its own: nothing is shared with the kernel.
namespace blossom::test {

/// All basis functions at t by the recursion of Cox and de Boor.
inline Eigen::VectorXd allBasis(int degree, const std::vector<double>& knots, double t) {
  const auto knot = [&](Eigen::Index i) { return knots[static_cast<std::size_t>(i)]; };
  const auto count = static_cast<Eigen::Index>(knots.size()) - 1;
  Eigen::VectorXd n = Eigen::VectorXd::Zero(count);
  Eigen::Index span = 0;
  for (Eigen::Index i = degree; i + degree + 1 < static_cast<Eigen::Index>(knots.size()); ++i)
    if (knot(i) < knot(i + 1) && knot(i) <= t) span = i;
  n[span] = 1;
  for (int p = 1; p <= degree; ++p)
    for (Eigen::Index i = 0; i + p < count; ++i) {
      const double left = knot(i + p) - knot(i), right = knot(i + p + 1) - knot(i + 1);
      n[i] = (left > 0 ? (t - knot(i)) / left * n[i] : 0) + (right > 0 ? (knot(i + p + 1) - t) / right * n[i + 1] : 0);
    }
  return n.head(count - degree);
}

/// Shares of the poles in the value at (u, v): a row for each row that is not a repetition of another.
inline Eigen::MatrixXd surfaceRow(const Surface& s, double u, double v, double closure) {
  const Eigen::VectorXd bu = allBasis(s.degreeU, s.knotsU, u), bv = allBasis(s.degreeV, s.knotsV, v);
  const Eigen::Index free = bu.size() - (closure == 0 ? 0 : s.degreeU);
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(free);
  for (Eigen::Index i = 0; i < bu.size(); ++i) rows[i % free] += (i < free ? 1 : closure) * bu[i];
  return rows * bv.transpose();
}

inline Vec4 valueAt(const Surface& s, const Eigen::MatrixXd& row) {
  Vec4 sum = Vec4::Zero();
  for (Eigen::Index i = 0; i < row.rows(); ++i)
    for (Eigen::Index j = 0; j < row.cols(); ++j)
      sum += row(i, j) * s.pole(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return sum;
}

/// A motion at one place.
struct PlaceOfMotion {
  double v = 0;
  Eigen::MatrixXd orientationRow, scalingRow;
  Vec4 r, s;
  Vec3 t, x;
  Eigen::Matrix3d turn;
  double turnClosure = 0, scaleClosure = 0;

  PlaceOfMotion(const Motion& m, double u, double atV) : v(atV) {
    turnClosure = m.closedU == ClosedU::No ? 0 : m.closedU == ClosedU::AntiPeriodic ? -1 : 1;
    scaleClosure = m.closedU == ClosedU::No ? 0 : 1;
    orientationRow = surfaceRow(m.orientation, u, v, turnClosure);
    scalingRow = surfaceRow(m.scaling, u, v, scaleClosure);
    r = valueAt(m.orientation, orientationRow);
    s = valueAt(m.scaling, scalingRow);
    const Eigen::VectorXd b = allBasis(m.trajectory.degree, m.trajectory.knots, v);
    Vec4 h = Vec4::Zero();
    for (Eigen::Index j = 0; j < b.size(); ++j) h += b[j] * m.trajectory.poles[static_cast<std::size_t>(j)];
    t = h.head<3>() / h[3];
    turn = Eigen::Quaterniond(r[0], r[1], r[2], r[3]).normalized().toRotationMatrix();
    x = t + turn * s.head<3>().cwiseProduct(m.point) / s[3];
  }
};

/// dC = N / sum(N^2) * delta on the poles of a surface; repeated rows are repeated again.
inline Surface withLeastChange(Surface s, const Eigen::MatrixXd& row, const Vec4& delta, double closure) {
  const Eigen::Index free = row.rows();
  for (std::size_t i = 0; i < s.countU(); ++i)
    for (std::size_t j = 0; j < s.countV(); ++j) {
      const auto k = static_cast<Eigen::Index>(i);
      const double share = row(k % free, static_cast<Eigen::Index>(j)) / row.squaredNorm();
      s.pole(i, j) += (k < free ? 1 : closure) * share * delta;
    }
  return s;
}

inline Motion translatedBy(const Motion& m, const PlaceOfMotion& at, const Vec3& to) {
  Motion moved = m;
  Eigen::VectorXd row = allBasis(m.trajectory.degree, m.trajectory.knots, at.v);
  for (Eigen::Index j = 0; j < row.size(); ++j) row[j] *= m.trajectory.poles[static_cast<std::size_t>(j)][3];
  row /= row.sum();
  for (Eigen::Index j = 0; j < row.size(); ++j) {
    Vec4& pole = moved.trajectory.poles[static_cast<std::size_t>(j)];
    pole.head<3>() += pole[3] * row[j] / row.squaredNorm() * (to - at.x);
  }
  return moved;
}

inline Motion scaledTo(const Motion& m, const PlaceOfMotion& at, const Vec3& to) {
  const Vec3 y = at.turn.transpose() * (to - at.t);
  Vec4 delta = Vec4::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (m.point[k] != 0) delta[k] = at.s[3] * y[k] / m.point[k] - at.s[k];
  Motion scaled = m;
  scaled.scaling = withLeastChange(m.scaling, at.scalingRow, delta, at.scaleClosure);
  return scaled;
}

inline Motion turnedBy(const Motion& m, const PlaceOfMotion& at, const Eigen::Quaterniond& dq) {
  const Eigen::Quaterniond r(at.r[0], at.r[1], at.r[2], at.r[3]), now = dq * r;
  const Vec4 delta(now.w() - r.w(), now.x() - r.x(), now.y() - r.y(), now.z() - r.z());
  Motion turned = m;
  turned.orientation = withLeastChange(m.orientation, at.orientationRow, delta, at.turnClosure);
  return turned;
}

/// The least turn that takes one direction to another, which is not its opposite. Eigen's own takes each file that sees it
/// four seconds to compile.
inline Eigen::Quaterniond turnBetween(const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  return Eigen::Quaterniond(from.norm() * to.norm() + from.dot(to), axis.x(), axis.y(), axis.z()).normalized();
}

inline Motion turnedTo(const Motion& m, const PlaceOfMotion& at, const Vec3& to) {
  return turnedBy(m, at, turnBetween(at.x - at.t, to - at.t));
}

inline Motion twistedBy(const Motion& m, const PlaceOfMotion& at, const Vec3& axis, double degrees) {
  return turnedBy(m, at, Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized())));
}

/// The largest difference of a pole of the three factors.
inline double poleDifference(const Motion& a, const Motion& b) {
  double most = 0;
  const auto compare = [&](const std::vector<Vec4>& p, const std::vector<Vec4>& q) {
    if (p.size() != q.size()) most = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) most = std::max(most, (p[i] - q[i]).norm());
  };
  compare(a.trajectory.poles, b.trajectory.poles);
  compare(a.orientation.poles, b.orientation.poles);
  compare(a.scaling.poles, b.scaling.poles);
  return most;
}

}  // namespace blossom::test
