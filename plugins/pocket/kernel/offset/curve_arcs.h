#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/medial/boundary.h"
#include "kernel/offset/arc_fit.h"

namespace blossom::pocket {

/// An end of an arc that follows a curve, at a parameter of the curve.
struct ArcJoint {
  double parameter = 0;
  TangentPoint place;
};

/// Arcs, smoothly joined, that follow the free-form curves of a boundary within a tolerance. Circles parallel to them follow
/// the offsets of the curves as closely, at any distance: distances to both differ by no more. O(n log n) for n pieces.
class CurveArcs {
 public:
  CurveArcs(const Boundary&, double tolerance, const Progress&);

  /// The joints along a curve, in order; none of a line or an arc.
  [[nodiscard]] std::span<const ArcJoint> of(std::size_t curve) const {
    return std::span(joints_).subspan(starts_[curve], starts_[curve + 1] - starts_[curve]);
  }

 private:
  std::vector<ArcJoint> joints_;     ///< of one curve after the other
  std::vector<std::size_t> starts_;  ///< by curve, and one more
};

}  // namespace blossom::pocket
