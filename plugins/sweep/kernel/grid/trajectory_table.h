#pragma once
#include <array>
#include <vector>

#include "geometry/bspline/curve.h"
#include "kernel/grid/basis_table.h"
#include "kernel/grid/grid_range.h"

namespace blossom::sweep {

/// A trajectory as Euclidean points and derivatives at many parameters, one array for each coordinate.
struct TrajectoryTable {
  std::array<std::vector<double>, 3> point, derivative;
  std::array<std::vector<double>, 3> second;  ///< only when the table of the basis has second derivatives
};

/// Evaluates at a range of the parameters of `basis`, which was made with the knots of the trajectory; the rest of `table`
/// stays as it is. O(degree) per parameter.
void tabulateTrajectory(const Curve& trajectory, const BasisTable& basis, const GridRange& range, TrajectoryTable& table);

}  // namespace blossom::sweep
