#include "kernel/grid/trajectory_table.h"

#include <span>

namespace blossom::sweep {

namespace {

Vec4 combination(std::span<const double> weights, const Vec4* poles) {
  Vec4 sum = Vec4::Zero();
  for (std::size_t b = 0; b < weights.size(); ++b) sum += weights[b] * poles[b];
  return sum;
}

void put(const Vec3& value, std::size_t l, std::array<std::vector<double>, 3>& arrays) {
  for (std::size_t c = 0; c < 3; ++c) arrays[c][l] = value[static_cast<Eigen::Index>(c)];
}

}  // namespace

void tabulateTrajectory(const Curve& trajectory, const BasisTable& basis, const GridRange& range, TrajectoryTable& table) {
  for (auto* arrays : {&table.point, &table.derivative})
    for (auto& array : *arrays) array.resize(basis.size());
  for (auto& array : table.second) array.resize(basis.second.empty() ? 0 : basis.size());
  for (std::size_t l = range.begin; l < range.end; ++l) {
    const Vec4* poles = trajectory.poles.data() + basis.first[l];
    const Vec4 value = combination(basis.values(l), poles), slope = combination(basis.derivatives(l), poles);
    // The quotient rule, one order after the other.
    const Vec3 point = value.head<3>() / value[3];
    const Vec3 derivative = (slope.head<3>() - point * slope[3]) / value[3];
    put(point, l, table.point);
    put(derivative, l, table.derivative);
    if (basis.second.empty()) continue;
    const Vec4 bend = combination(basis.seconds(l), poles);
    put((bend.head<3>() - 2 * slope[3] * derivative - bend[3] * point) / value[3], l, table.second);
  }
}

}  // namespace blossom::sweep
