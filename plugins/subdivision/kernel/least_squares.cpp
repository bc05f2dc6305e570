#include "kernel/least_squares.h"

#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "core/error.h"

namespace blossom::subdivision {
namespace {

constexpr double laplacian = 0.1;
constexpr double largestDense = 4e6;  // entries

using Three = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Place of a control point among the free ones; -1 when it is not free.
int columnOf(std::span<const int> free, int point) {
  const auto found = std::lower_bound(free.begin(), free.end(), point);
  return found != free.end() && *found == point ? static_cast<int>(found - free.begin()) : -1;
}

Three rightSide(std::span<const Vec3> residuals) {
  Three right(static_cast<Eigen::Index>(residuals.size()), 3);
  for (std::size_t i = 0; i < residuals.size(); ++i) right.row(static_cast<Eigen::Index>(i)) = residuals[i].transpose();
  return right;
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse matrixOf(std::span<const Row> rows, std::span<const int> free) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i < rows[r].indices.size(); ++i)
      if (const int column = columnOf(free, rows[r].indices[i]); column >= 0)
        entries.emplace_back(static_cast<int>(r), column, rows[r].weights[i]);
  Sparse matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(free.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Sparse stiffnessMatrix(std::span<const int> free, std::span<const double> resistance,
                       std::span<const std::pair<int, int>> edges, double lambda) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < static_cast<int>(free.size()); ++i)
    entries.emplace_back(i, i, lambda * resistance[static_cast<std::size_t>(i)]);
  const double stiff = lambda * laplacian;
  for (const auto& [from, to] : edges) {
    const int a = columnOf(free, from), b = columnOf(free, to);
    if (a >= 0) entries.emplace_back(a, a, stiff);
    if (b >= 0) entries.emplace_back(b, b, stiff);
    if (a < 0 || b < 0) continue;
    entries.emplace_back(a, b, -stiff);
    entries.emplace_back(b, a, -stiff);
  }
  const auto size = static_cast<Eigen::Index>(free.size());
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

struct LeastSquares::Data {
  Sparse matrix;
  Eigen::SimplicialLDLT<Sparse> normal;                           ///< when lambda is above 0
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> dense;  ///< when it is 0
  bool stiff = false;

  void factorDense() {
    if (static_cast<double>(matrix.rows()) * static_cast<double>(matrix.cols()) > largestDense)
      throw Error(ErrorCode::LimitExceeded, "There are too many samples and free points for the shortest solution.",
                  "Give a lambda above 0, such as 1e-6.");
    dense.setThreshold(1e-12);  // rounding, and nothing else
    dense.compute(Eigen::MatrixXd(matrix));
  }
};

LeastSquares::LeastSquares(std::span<const Row> rows, std::span<const int> free, std::span<const double> resistance,
                           std::span<const std::pair<int, int>> edges, double lambda, const Progress& progress)
    : data_(std::make_unique<Data>()) {
  data_->matrix = matrixOf(rows, free);
  data_->stiff = lambda > 0;
  progress.check();
  if (!data_->stiff) {
    data_->factorDense();
    return;
  }
  Sparse normal = stiffnessMatrix(free, resistance, edges, lambda);
  normal += Sparse(data_->matrix.transpose() * data_->matrix);
  data_->normal.compute(normal);
  if (data_->normal.info() != Eigen::Success)
    throw Error(ErrorCode::Degenerate, "The equations of the deformation have no stable solution.", "Give a larger lambda.");
}

LeastSquares::~LeastSquares() = default;

std::vector<Vec3> LeastSquares::solve(std::span<const Vec3> residuals) const {
  const Three right = rightSide(residuals);
  const Three solution =
      data_->stiff ? Three(data_->normal.solve(data_->matrix.transpose() * right)) : Three(data_->dense.solve(right));
  if (!solution.allFinite())
    throw Error(ErrorCode::Degenerate, "The equations of the deformation have no solution.", "Give a larger lambda.");
  std::vector<Vec3> moved(static_cast<std::size_t>(solution.rows()));
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = solution.row(static_cast<Eigen::Index>(i)).transpose();
  return moved;
}

double stiffness(std::span<const Vec3> moved, std::span<const int> free, std::span<const double> resistance,
                 std::span<const std::pair<int, int>> edges) {
  double sum = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) sum += resistance[i] * moved[i].squaredNorm();
  const auto of = [&](int point) -> Vec3 {
    const int column = columnOf(free, point);
    return column < 0 ? Vec3(Vec3::Zero()) : moved[static_cast<std::size_t>(column)];
  };
  for (const auto& [from, to] : edges) sum += laplacian * (of(from) - of(to)).squaredNorm();
  return sum;
}

}  // namespace blossom::subdivision
