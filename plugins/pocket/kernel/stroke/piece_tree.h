#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom::pocket {

struct FlatBox {
  Vec2 low, high;
  [[nodiscard]] double distance(const Vec2& x) const { return (low - x).cwiseMax(x - high).cwiseMax(Vec2::Zero()).norm(); }
  [[nodiscard]] bool meets(const FlatBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Bounding volume hierarchy over straight pieces. Immutable. Built in O(n log n).
class PieceTree {
 public:
  PieceTree() = default;
  explicit PieceTree(const std::vector<std::pair<Vec2, Vec2>>& pieces);

  /// Calls `visit(piece)` for the pieces that may be nearer to x than `best()`, nearest boxes first.
  template <class Visit, class Best>
  void near(const Vec2& x, const Visit& visit, const Best& best) const {
    if (nodes_.empty()) return;
    std::array<std::pair<double, std::size_t>, maximumOpen> open;
    open[0] = {nodes_[0].box.distance(x), 0};
    for (std::size_t waiting = 1; waiting > 0;) {
      const auto [distance, index] = open[--waiting];
      if (distance > best()) continue;
      const Node& node = nodes_[index];
      if (node.count > 0) {
        for (std::size_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
        continue;
      }
      const std::size_t left = index + 1;
      const std::size_t right = node.first;
      const double toLeft = nodes_[left].box.distance(x);
      const double toRight = nodes_[right].box.distance(x);
      const bool leftFirst = toLeft <= toRight;
      open[waiting++] = {leftFirst ? toRight : toLeft, leftFirst ? right : left};
      open[waiting++] = {leftFirst ? toLeft : toRight, leftFirst ? left : right};
    }
  }

  /// Calls `visit(piece)` for every piece whose box meets `box`.
  template <class Visit>
  void meeting(const FlatBox& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<std::size_t, maximumOpen> open{0};
    for (std::size_t waiting = 1; waiting > 0;) {
      const std::size_t index = open[--waiting];
      const Node& node = nodes_[index];
      if (!node.box.meets(box)) continue;
      if (node.count > 0) {
        for (std::size_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
        continue;
      }
      open[waiting++] = node.first;
      open[waiting++] = index + 1;
    }
  }

 private:
  static constexpr std::size_t maximumOpen = 128;  // halving keeps the tree below half as deep

  /// The left child follows its parent; `first` is the right child, or of a leaf the first of its pieces.
  struct Node {
    FlatBox box;
    std::size_t first = 0, count = 0;
  };
  void build(const std::vector<std::pair<Vec2, Vec2>>& pieces, std::size_t from, std::size_t to);

  std::vector<Node> nodes_;
  std::vector<std::size_t> order_;
};

/// The point of a straight piece nearest to x, as its share of the way from `a` to `b`.
inline double nearestShare(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  if (!(squared > 0)) return 0;
  const double share = (x - a).dot(along) / squared;
  return share < 0 ? 0 : share > 1 ? 1 : share;
}

}  // namespace blossom::pocket
