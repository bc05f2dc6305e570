#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// How far each free control point moves, so that sum |L d - r|^2 + lambda |D d|^2 is least; |D d|^2 is the sum of |d_i|^2,
/// each times the resistance of the point, and a tenth of the squared differences along edges of the cage, points that are
/// not free standing still. With lambda 0 it is the shortest d of all that make |L d - r| least; directions whose effect is
/// within rounding of none, 1e-12 of the strongest, are left out. Factored once for x, y, z and every r: while something is
/// dragged, a frame is one back-substitution.
class LeastSquares {
 public:
  /// @param rows one for each residual; what they have of points that are not free does not count
  /// @param free sorted  @param resistance one for each free point
  /// @throws Error LimitExceeded when lambda is 0 and the problem is large, Degenerate when there is no solution, Cancelled.
  LeastSquares(std::span<const Row> rows, std::span<const int> free, std::span<const double> resistance,
               std::span<const std::pair<int, int>> edges, double lambda, const Progress&);
  ~LeastSquares();
  LeastSquares(const LeastSquares&) = delete;
  LeastSquares& operator=(const LeastSquares&) = delete;
  /// The d of each free point. @throws Error Degenerate when there is no solution.
  [[nodiscard]] std::vector<Vec3> solve(std::span<const Vec3> residuals) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// |D d|^2, the second term without its factor.
double stiffness(std::span<const Vec3> moved, std::span<const int> free, std::span<const double> resistance,
                 std::span<const std::pair<int, int>> edges);

}  // namespace blossom::subdivision
