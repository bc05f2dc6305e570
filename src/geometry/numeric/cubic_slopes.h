#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

namespace blossom {

/// Rows of numbers, one row for each place; all columns are interpolated alike.
using NumberRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Slopes of the piecewise cubic functions through `values`, whose places are `steps` apart, twice continuously
/// differentiable (de Boor, A Practical Guide to Splines, chapter IV). The slopes at the ends are `start` and `end` as far
/// as given, else the second derivative is 0 there. O(rows * columns). @pre one step or more, all above 0. Hand-written
/// because OCCT's GeomAPI_Interpolate takes points of three coordinates: the hundreds of columns of a surface would each
/// eliminate the same system again.
NumberRows cubicSlopes(std::span<const double> steps, const Eigen::Ref<const NumberRows>& values,
                       const std::optional<Eigen::RowVectorXd>& start = {},
                       const std::optional<Eigen::RowVectorXd>& end = {});

/// The same around closed functions: one more step leads back to the first row.
NumberRows periodicCubicSlopes(std::span<const double> steps, const Eigen::Ref<const NumberRows>& values);

}  // namespace blossom
