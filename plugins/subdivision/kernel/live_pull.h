#pragma once
#include <array>
#include <memory>

#include "kernel/deform.h"
#include "kernel/least_squares.h"
#include "kernel/limit_surface.h"

namespace blossom::subdivision {

/// Interactive pulls on a limit surface: feet, free points and the factorisation are computed once, then every movement of
/// the mouse is one back-substitution and a pass over the part of the surface influenced by the free points. The result
/// equals that of `deform` with the same pulls. With the rule of the paper the free points depend on the targets of the
/// pulls: when they change, free points and factorisation are computed again.
class LivePull {
 public:
  struct Handle {
    Foot foot;
    Vec3 to = Vec3::Zero();
  };

  /// O(patches) to find the influenced part, 5 ms for 5,000 of them. @pre at least one handle; the surface outlives this.
  /// @throws Error as `deform`.
  LivePull(const LimitSurface&, std::span<const Vec3> points, std::vector<Handle>, const DeformOptions&,
           const Progress& = Progress::none());

  /// Moves handle k to a position. O(free points^1.5 + influenced samples).
  /// @throws Error InvalidInput when the rule of the paper finds no free point for it; nothing changes then.
  void drag(std::size_t k, const Vec3& to);

  /// All control points; those not free are bitwise unchanged.
  [[nodiscard]] const std::vector<Vec3>& points() const { return moved_; }
  [[nodiscard]] const std::vector<int>& freePoints() const { return free_; }
  /// The influenced part of the surface: samples of its patches in lattices, and the triangles between them.
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
  std::vector<Vec3> still_, samples_;  ///< samples before the drag, and current ones
  std::vector<Row> sampleRows_;        ///< indices refer to free_
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace blossom::subdivision
