#include "kernel/near_pairs.h"

#include <algorithm>
#include <numeric>

namespace blossom::minkowski {
namespace {

constexpr std::size_t leafSize = 6;

Box2 around(std::span<const Box2> boxes, std::span<const std::size_t> members) {
  Box2 all = boxes[members.front()];
  for (const std::size_t i : members) {
    all.low = all.low.cwiseMin(boxes[i].low);
    all.high = all.high.cwiseMax(boxes[i].high);
  }
  return all;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box2> boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (boxes.empty()) return;
  nodes_.push_back({around(boxes, order_), 0, boxes.size()});
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node node = nodes_[k];
    if (node.size() <= leafSize) continue;
    const Vec2 size = node.box.size();
    const int axis = size.x() >= size.y() ? 0 : 1;
    const std::size_t middle = (node.first + node.last) / 2;
    const auto at = [&](std::size_t place) { return order_.begin() + static_cast<std::ptrdiff_t>(place); };
    std::nth_element(at(node.first), at(middle), at(node.last), [&](std::size_t i, std::size_t j) {
      return boxes[i].low[axis] + boxes[i].high[axis] < boxes[j].low[axis] + boxes[j].high[axis];
    });
    const std::span<const std::size_t> members(order_);
    nodes_[k].left = nodes_.size();
    nodes_.push_back({around(boxes, members.subspan(node.first, middle - node.first)), node.first, middle});
    nodes_[k].right = nodes_.size();
    nodes_.push_back({around(boxes, members.subspan(middle, node.last - middle)), middle, node.last});
  }
}

}  // namespace blossom::minkowski
