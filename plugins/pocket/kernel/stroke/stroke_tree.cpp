#include "kernel/stroke/stroke_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace blossom::pocket {

namespace {

constexpr std::size_t leafSize = 4;

double boxDistance(const Vec2& low, const Vec2& high, const Vec2& otherLow, const Vec2& otherHigh) {
  return (low - otherHigh).cwiseMax(otherLow - high).cwiseMax(Vec2::Zero()).norm();
}

}  // namespace

StrokeTree::StrokeTree(std::vector<Stroke> strokes) : strokes_(std::move(strokes)), order_(strokes_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!strokes_.empty()) build(0, strokes_.size());
}

void StrokeTree::build(std::size_t from, std::size_t to) {
  Node node{strokes_[order_[from]].from, strokes_[order_[from]].from};
  for (std::size_t i = from; i < to; ++i) {
    const auto [low, high] = strokes_[order_[i]].box();
    node.low = node.low.cwiseMin(low);
    node.high = node.high.cwiseMax(high);
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (to - from <= leafSize) {
    nodes_[index].first = from;
    nodes_[index].count = to - from;
    return;
  }
  const Vec2 extent = node.high - node.low;
  const int axis = extent.x() >= extent.y() ? 0 : 1;
  const std::size_t middle = from + (to - from) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(middle), at(to),
                   [&](std::size_t a, std::size_t b) { return strokes_[a].at(0.5)[axis] < strokes_[b].at(0.5)[axis]; });
  build(from, middle);
  nodes_[index].first = nodes_.size();
  build(middle, to);
}

template <class Measure>
StrokeTree::Nearest StrokeTree::search(const Vec2& low, const Vec2& high, double bound, const Measure& measure) const {
  Nearest best{bound, strokes_.size()};
  if (nodes_.empty()) return best;
  std::array<std::pair<double, std::size_t>, 128> open;
  open[0] = {boxDistance(nodes_[0].low, nodes_[0].high, low, high), 0};
  for (std::size_t waiting = 1; waiting > 0;) {
    const auto [away, index] = open[--waiting];
    if (away >= best.distance) continue;
    const Node& node = nodes_[index];
    if (node.count > 0) {
      for (std::size_t i = node.first; i < node.first + node.count; ++i)
        if (const double d = measure(strokes_[order_[i]]); d < best.distance) best = {d, order_[i]};
      continue;
    }
    const std::size_t left = index + 1, right = node.first;
    const double toLeft = boxDistance(nodes_[left].low, nodes_[left].high, low, high);
    const double toRight = boxDistance(nodes_[right].low, nodes_[right].high, low, high);
    const bool leftFirst = toLeft <= toRight;
    open[waiting++] = leftFirst ? std::pair(toRight, right) : std::pair(toLeft, left);
    open[waiting++] = leftFirst ? std::pair(toLeft, left) : std::pair(toRight, right);
  }
  return best;
}

StrokeTree::Nearest StrokeTree::nearest(const Vec2& p, double bound) const {
  return search(p, p, bound, [&](const Stroke& s) { return distance(s, p); });
}

StrokeTree::Nearest StrokeTree::nearest(const Stroke& wanted, double bound) const {
  const auto [low, high] = wanted.box();
  return search(low, high, bound, [&](const Stroke& s) { return distance(s, wanted); });
}

}  // namespace blossom::pocket
