#pragma once
#include "core/progress.h"
#include "kernel/limit_shape.h"

namespace blossom::subdivision {

/// Finds closest points on a limit shape: Newton's method on the patches that the nearest of many spread points lie on. The
/// spread is made once, so that the search can be repeated after control points moved.
class FootFinder {
 public:
  /// O(patches). @throws Error Cancelled.
  FootFinder(const LimitShape&, const Progress&);

  /// One foot for each sample. Each of `before`, the feet of the last time (or empty), is improved too, so that no distance
  /// grows when points did not move. O((samples + patches) log patches), in parallel. @throws Error Cancelled.
  [[nodiscard]] std::vector<Foot> feet(std::span<const Vec3> samples, std::span<const Vec3> points,
                                       std::span<const Foot> before, const Progress&) const;

  [[nodiscard]] const std::vector<Row>& spreadRows() const { return rows_; }

 private:
  const LimitShape& shape_;
  std::vector<Foot> spread_;
  std::vector<Row> rows_;
};

/// The closest point to `sample` that is found downhill from `start` within its patch.
Foot descend(const LimitShape&, std::span<const Vec3> points, const Vec3& sample, Foot start);

}  // namespace blossom::subdivision
