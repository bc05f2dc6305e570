#include "kernel/stroke/piece_tree.h"

#include <algorithm>
#include <numeric>

namespace blossom::pocket {

PieceTree::PieceTree(const std::vector<std::pair<Vec2, Vec2>>& pieces) : order_(pieces.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  nodes_.reserve(pieces.size());
  if (!pieces.empty()) build(pieces, 0, pieces.size());
}

void PieceTree::build(const std::vector<std::pair<Vec2, Vec2>>& pieces, std::size_t from, std::size_t to) {
  constexpr std::size_t leafSize = 4;
  const std::size_t index = nodes_.size();
  const auto& start = pieces[order_[from]];
  nodes_.push_back({{start.first, start.first}, from, to - from});
  FlatBox box{start.first, start.first};
  for (std::size_t i = from; i < to; ++i) {
    const auto& [a, b] = pieces[order_[i]];
    box.low = box.low.cwiseMin(a).cwiseMin(b);
    box.high = box.high.cwiseMax(a).cwiseMax(b);
  }
  nodes_[index].box = box;
  if (to - from <= leafSize) return;
  const Vec2 size = box.high - box.low;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const std::size_t middle = from + (to - from) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(middle), at(to), [&](std::size_t i, std::size_t k) {
    return pieces[i].first[axis] + pieces[i].second[axis] < pieces[k].first[axis] + pieces[k].second[axis];
  });
  build(pieces, from, middle);
  nodes_[index].first = nodes_.size();
  nodes_[index].count = 0;
  build(pieces, middle, to);
}

}  // namespace blossom::pocket
