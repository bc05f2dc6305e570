#pragma once
#include "core/progress.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// Finds closest points on a limit shape: Newton's method on the patches of the nearest seeds. The seeds are computed once,
/// so that the search can be repeated after control points have moved.
class FootFinder {
 public:
  /// O(patches). @throws Error Cancelled.
  FootFinder(const LimitShape&, const Progress&);

  /// One foot per sample. Feet of the previous search in `before` (or none) are improved as well, so that no distance grows
  /// when points did not move. O((samples + patches) log patches), in parallel. @throws Error Cancelled.
  [[nodiscard]] std::vector<Foot> feet(std::span<const Vec3> samples, std::span<const Vec3> points,
                                       std::span<const Foot> before, const Progress&) const;

  [[nodiscard]] const std::vector<Row>& seedRows() const { return rows_; }

 private:
  const LimitShape& shape_;
  std::vector<Foot> seeds_;
  std::vector<Row> rows_;
};

/// Descends from `start` to the closest point to `sample` within the patch.
Foot descend(const LimitShape&, std::span<const Vec3> points, const Vec3& sample, Foot start);

}  // namespace blossom::subdivision
