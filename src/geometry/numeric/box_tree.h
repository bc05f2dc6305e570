#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/boxes.h"

namespace blossom {

/// Hierarchy of boxes over numbered items (Ericson, Real-Time Collision Detection, chapter 6), halved at the median of the
/// centres along the longest side. It keeps no items: its users test these themselves. Immutable, safe to use from several
/// threads. N is 2 or 3. (For rays there is scene/ray_tree.h.) Hand-written because CGAL's AABB tree and Eigen's unsupported
/// KdBVH offer neither a walk that ends where its user says nor two trees walked at once.
template <int N>
class BoxTree {
 public:
  using Box = Eigen::AlignedBox<double, N>;

  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;  ///< its items in `order`, those of an inner node too
    std::uint32_t right = 0;             ///< its second child; the first one follows the node itself. 0: a leaf
    std::uint32_t last = 0;              ///< the highest number among its items
    [[nodiscard]] bool isLeaf() const { return right == 0; }
  };

  BoxTree() = default;
  /// O(n log n). @throws Error Cancelled.
  explicit BoxTree(std::span<const Box> boxes, std::size_t leafSize = 4, const Progress& = Progress::none());

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  /// The root is the first one.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Numbers of the items as the leaves hold them.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls `visit(item)` for the items of all leaves whose boxes, and those around them, are wanted; of two boxes the nearer
  /// one first. `distanceTo(box)` is any measure that does not fall towards the leaves; `wants(distance)` may grow stricter
  /// during the walk.
  template <class DistanceTo, class Visit, class Wants>
  void walk(const DistanceTo& distanceTo, const Visit& visit, const Wants& wants) const {
    if (nodes_.empty()) return;
    std::array<Waiting, mostWaiting> stack;
    stack[0] = {distanceTo(nodes_[0].box), 0};
    for (std::size_t waiting = 1; waiting > 0;) {
      const auto [distance, index] = stack[--waiting];
      if (!wants(distance)) continue;
      const Node& node = nodes_[index];
      if (node.isLeaf()) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(std::size_t{order_[i]});
        continue;
      }
      const Waiting left{distanceTo(nodes_[index + 1].box), index + 1},
          right{distanceTo(nodes_[node.right].box), node.right};
      const bool leftFirst = left.distance <= right.distance;
      stack[waiting++] = leftFirst ? right : left;
      stack[waiting++] = leftFirst ? left : right;
    }
  }

  /// Calls `visit(item)` for the items numbered `from` or higher of all leaves whose boxes meet `box`.
  template <class Visit>
  void meeting(const Box& box, const Visit& visit, std::size_t from = 0) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, mostWaiting> stack{0};
    for (std::size_t waiting = 1; waiting > 0;) {
      const std::uint32_t index = stack[--waiting];
      const Node& node = nodes_[index];
      if (node.last < from || !node.box.intersects(box)) continue;
      if (node.isLeaf()) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          if (order_[i] >= from) visit(std::size_t{order_[i]});
        continue;
      }
      stack[waiting++] = node.right;
      stack[waiting++] = index + 1;
    }
  }

 private:
  struct Waiting {
    double distance;
    std::uint32_t node;
  };
  static constexpr std::size_t mostWaiting = 72;  ///< halving 2^32 items goes 32 deep, and every level leaves one waiting

  struct Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

extern template class BoxTree<2>;
extern template class BoxTree<3>;

/// Calls `f(i, j)` for all pairs of boxes that come within `margin` of one another, each pair once, until f says false.
/// O(n log n + k) for k pairs of well-spread boxes. @throws Error Cancelled.
template <int N, class F>
void forEachNearPair(std::span<const Eigen::AlignedBox<double, N>> boxes, double margin, const Progress& progress, F f) {
  if (boxes.empty()) return;
  constexpr std::size_t leafSize = 6;
  const BoxTree<N> tree(boxes, leafSize, progress);
  const auto& nodes = tree.nodes();
  const auto& order = tree.order();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
  while (!open.empty()) {
    progress.check();
    const auto [a, b] = open.back();
    open.pop_back();
    const auto &first = nodes[a], &second = nodes[b];
    if (!comeNear(first.box, second.box, margin)) continue;
    if (first.isLeaf() && second.isLeaf()) {
      for (std::uint32_t k = first.first; k < first.first + first.count; ++k)
        for (std::uint32_t l = a == b ? k + 1 : second.first; l < second.first + second.count; ++l)
          if (comeNear(boxes[order[k]], boxes[order[l]], margin) && !f(std::size_t{order[k]}, std::size_t{order[l]})) return;
    } else if (a == b) {
      open.insert(open.end(), {{a + 1, a + 1}, {first.right, first.right}, {a + 1, first.right}});
    } else if (second.isLeaf() || (!first.isLeaf() && first.count >= second.count)) {
      open.insert(open.end(), {{a + 1, b}, {first.right, b}});
    } else {
      open.insert(open.end(), {{a, b + 1}, {a, second.right}});
    }
  }
}

}  // namespace blossom
