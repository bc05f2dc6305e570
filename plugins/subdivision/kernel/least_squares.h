#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// Movements d of the free control points that minimise |L d - r|^2 + lambda |D d|^2. |D d|^2 is the sum of |d_i|^2, each
/// times the resistance of the point, plus a tenth of the squared differences along edges of the cage, with d = 0 at points
/// that are not free. With lambda 0 it is the shortest d that minimises |L d - r|; singular directions below 1e-12 of the
/// strongest are left out. Factored once for x, y, z and every r: while dragging, a frame is one back-substitution.
class LeastSquares {
 public:
  /// @param rows one per residual; weights of points that are not free are ignored
  /// @param free sorted  @param resistance one per free point
  /// @throws Error LimitExceeded when lambda is 0 and the problem is large, Degenerate when there is no solution, Cancelled.
  LeastSquares(std::span<const Row> rows, std::span<const int> free, std::span<const double> resistance,
               std::span<const std::pair<int, int>> edges, double lambda, const Progress&);
  ~LeastSquares();
  LeastSquares(const LeastSquares&) = delete;
  LeastSquares& operator=(const LeastSquares&) = delete;
  /// The movements of the free points. @throws Error Degenerate when there is no solution.
  [[nodiscard]] std::vector<Vec3> solve(std::span<const Vec3> residuals) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// |D d|^2, the second term without lambda.
double stiffness(std::span<const Vec3> moved, std::span<const int> free, std::span<const double> resistance,
                 std::span<const std::pair<int, int>> edges);

}  // namespace blossom::subdivision
