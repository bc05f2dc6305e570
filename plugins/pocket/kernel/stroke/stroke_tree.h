#pragma once
#include <cstddef>
#include <vector>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Bounding volume hierarchy of strokes: minimum distances in O(log n). Immutable, usable from several threads.
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
  struct Node {
    Vec2 low, high;
    std::size_t first = 0, count = 0;  ///< of a leaf: its strokes; else `first` is the right child, the left one follows
  };
  void build(std::size_t from, std::size_t to);
  template <class Measure>
  Nearest search(const Vec2& low, const Vec2& high, double bound, const Measure&) const;

  std::vector<Stroke> strokes_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace blossom::pocket
