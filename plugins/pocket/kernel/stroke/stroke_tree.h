#pragma once
#include <cstddef>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Least distances to many strokes in O(log n). Immutable, safe to use from several threads.
class StrokeTree {
 public:
  StrokeTree() = default;
  explicit StrokeTree(std::vector<Stroke>);

  [[nodiscard]] const std::vector<Stroke>& strokes() const { return strokes_; }
  [[nodiscard]] bool empty() const { return strokes_.empty(); }

  struct Nearest {
    double distance;
    std::size_t stroke;  ///< the number of strokes when none is nearer than the bound
  };
  /// The nearest stroke, if it is nearer than `bound`; else `bound` itself.
  [[nodiscard]] Nearest nearest(const Vec2&, double bound = 1e300) const;
  [[nodiscard]] Nearest nearest(const Stroke&, double bound = 1e300) const;

 private:
  template <class Wanted, class DistanceTo>
  Nearest search(const Wanted&, double bound, const DistanceTo&) const;

  std::vector<Stroke> strokes_;
  BoxTree<2> tree_;
};

}  // namespace blossom::pocket
