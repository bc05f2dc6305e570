#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "kernel/polygons.h"

namespace blossom::minkowski {

/// Balanced tree of boxes, split at the middle of the longer side.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box2> boxes);

  struct Node {
    Box2 box;
    std::size_t first = 0, last = 0;  ///< of `order`
    std::size_t left = 0, right = 0;  ///< nodes; 0 for a leaf
    [[nodiscard]] bool isLeaf() const { return left == 0; }
    [[nodiscard]] std::size_t size() const { return last - first; }
  };
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  std::vector<Node> nodes_;
  std::vector<std::size_t> order_;
};

inline bool comeNear(const Box2& a, const Box2& b, double margin) {
  return (a.low.array() <= b.high.array() + margin).all() && (b.low.array() <= a.high.array() + margin).all();
}

/// Calls f(i, j) once for each pair of boxes within `margin` of one another, until f returns false. O(n log n + k) for k
/// pairs of well-distributed boxes.
template <class F>
void forEachNearPair(std::span<const Box2> boxes, double margin, const Progress& progress, F f) {
  if (boxes.empty()) return;
  const BoxTree tree(boxes);
  const std::vector<BoxTree::Node>& nodes = tree.nodes();
  const std::vector<std::size_t>& order = tree.order();
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, 0}};
  while (!open.empty()) {
    progress.check();
    const auto [a, b] = open.back();
    open.pop_back();
    const BoxTree::Node &first = nodes[a], &second = nodes[b];
    if (!comeNear(first.box, second.box, margin)) continue;
    if (first.isLeaf() && second.isLeaf()) {
      for (std::size_t k = first.first; k < first.last; ++k)
        for (std::size_t l = a == b ? k + 1 : second.first; l < second.last; ++l)
          if (comeNear(boxes[order[k]], boxes[order[l]], margin) && !f(order[k], order[l])) return;
    } else if (a == b) {
      open.insert(open.end(), {{first.left, first.left}, {first.right, first.right}, {first.left, first.right}});
    } else if (second.isLeaf() || (!first.isLeaf() && first.size() >= second.size())) {
      open.insert(open.end(), {{first.left, b}, {first.right, b}});
    } else {
      open.insert(open.end(), {{a, second.left}, {a, second.right}});
    }
  }
}

}  // namespace blossom::minkowski
