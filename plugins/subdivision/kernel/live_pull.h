#pragma once
#include <array>
#include <memory>

#include "kernel/deform.h"
#include "kernel/least_squares.h"
#include "kernel/limit_surface.h"

namespace blossom::subdivision {

/// Places of a limit surface that are dragged: feet, free points and factor are found once, then every movement of the mouse
/// is one back-substitution and a pass over the part of the surface that the free points reach. Moving the pulls to where
/// `deform` is told to take them gives the points that `deform` gives. By the paper's rule it depends on where pulls go
/// which points are free: when that changes, free points and factor are found anew.
class LivePull {
 public:
  struct Handle {
    Foot foot;
    Vec3 to = Vec3::Zero();
  };

  /// O(patches) to find what is within reach, 5 ms for 5,000 of them. @pre at least one handle; the surface outlives this.
  /// @throws Error as `deform`.
  LivePull(const LimitSurface&, std::span<const Vec3> points, std::vector<Handle>, const DeformOptions&,
           const Progress& = Progress::none());

  /// Handle k goes there. O(free points^1.5 + samples within reach).
  /// @throws Error InvalidInput when the paper's rule finds no free point for it; all stays as it was.
  void drag(std::size_t k, const Vec3& to);

  /// All control points; those that are not free have every bit they had.
  [[nodiscard]] const std::vector<Vec3>& points() const { return moved_; }
  [[nodiscard]] const std::vector<int>& freePoints() const { return free_; }
  /// The surface within reach: samples of its patches in lattices, and the triangles between them.
  [[nodiscard]] const std::vector<Vec3>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

 private:
  [[nodiscard]] std::vector<int> chosenFree() const;
  void reach(std::vector<int> free, const Progress&);
  void solve();
  void addPatch(int patch);

  const LimitSurface& surface_;
  DeformOptions options_;
  std::vector<std::pair<int, int>> edges_;

  std::vector<Vec3> points_, moved_;
  std::vector<Handle> handles_;
  std::vector<Row> rows_;
  std::vector<int> free_;
  std::unique_ptr<LeastSquares> factor_;
  std::vector<Vec3> still_, samples_;  ///< samples before, and now
  std::vector<Row> sampleRows_;        ///< over free points, by their place in free_
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace blossom::subdivision
