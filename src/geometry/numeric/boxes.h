#pragma once
#include <Eigen/Geometry>
#include <cmath>

namespace blossom {

/// Boxes along the axes, empty when made without corners.
using Box2 = Eigen::AlignedBox<double, 2>;
using Box3 = Eigen::AlignedBox<double, 3>;

/// The least distance of a box and a point, squared; 0 inside.
template <int N>
double squaredDistance(const Eigen::AlignedBox<double, N>& box, const Eigen::Matrix<double, N, 1>& p) {
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0).squaredNorm();
}
template <int N>
double boxDistance(const Eigen::AlignedBox<double, N>& box, const Eigen::Matrix<double, N, 1>& p) {
  return std::sqrt(squaredDistance(box, p));
}

/// The least distance of two boxes; 0 where they meet.
template <int N>
double boxDistance(const Eigen::AlignedBox<double, N>& a, const Eigen::AlignedBox<double, N>& b) {
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0).norm();
}

/// Whether two boxes come within `margin` of one another along every axis.
template <int N>
bool comeNear(const Eigen::AlignedBox<double, N>& a, const Eigen::AlignedBox<double, N>& b, double margin) {
  return (a.min().array() <= b.max().array() + margin).all() && (b.min().array() <= a.max().array() + margin).all();
}

}  // namespace blossom
