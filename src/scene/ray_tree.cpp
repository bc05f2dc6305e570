#include "scene/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace blossom {

void FloatBox::add(const Vec3& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    // What lies inside is the usual case, and rounding takes long.
    const double value = p[static_cast<Eigen::Index>(k)];
    if (value < low[k]) low[k] = std::nextafter(static_cast<float>(value), std::numeric_limits<float>::lowest());
    if (value > high[k]) high[k] = std::nextafter(static_cast<float>(value), std::numeric_limits<float>::max());
  }
}

class RayTree::Builder {
 public:
  Builder(const std::vector<FloatBox>& items, std::vector<Node>& nodes, std::vector<int>& order)
      : items_(items), nodes_(nodes), order_(order) {}

  void run() {
    order_.resize(items_.size());
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(items_.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<int>(items_.size()), 0);
  }

 private:
  static constexpr int bins = 12, fewest = 4;
  struct Cut {
    std::size_t axis = 0;
    int bin = -1;  // items of bins up to this one go left
    float cost = std::numeric_limits<float>::max();
  };

  [[nodiscard]] const FloatBox& box(int place) const {
    return items_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  }
  static float middle(const FloatBox& box, std::size_t axis) { return (box.low[axis] + box.high[axis]) / 2; }
  static FloatBox middleOf(const FloatBox& box) {
    const std::array<float, 3> at{middle(box, 0), middle(box, 1), middle(box, 2)};
    return {at, at};
  }

  void split(std::size_t node, int first, int count, int depth) {
    FloatBox all, middles;
    for (int i = first; i < first + count; ++i) {
      all.add(box(i));
      middles.add(middleOf(box(i)));
    }
    nodes_[node] = {all, first, count};
    if (count <= fewest || depth >= deepest) return;
    const int left = divide(first, count, middles);
    const auto children = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = children;
    nodes_[node].count = 0;
    split(static_cast<std::size_t>(children), first, left, depth + 1);
    split(static_cast<std::size_t>(children) + 1, first + left, count - left, depth + 1);
  }

  // Puts the items of the left child in front. @returns how many they are.
  int divide(int first, int count, const FloatBox& middles) {
    Cut best;
    fillBins(first, count, middles);
    for (std::size_t axis = 0; axis < 3; ++axis) tryAxis(axis, count, best);
    const auto begin = order_.begin() + first, end = begin + count;
    const auto half = begin + count / 2;
    if (best.bin >= 0) {
      const auto border = std::partition(begin, end, [&](int item) {
        return binOf(middle(items_[static_cast<std::size_t>(item)], best.axis), best.axis, middles) <= best.bin;
      });
      if (border != begin && border != end) return static_cast<int>(border - begin);
    }
    return static_cast<int>(half - begin);  // all middles are one point
  }

  static int binOf(float value, std::size_t axis, const FloatBox& middles) {
    const float width = middles.high[axis] - middles.low[axis];
    return std::clamp(static_cast<int>((value - middles.low[axis]) / width * bins), 0, bins - 1);
  }

  /// The boxes of the items in each bin of each axis, in one pass.
  void fillBins(int first, int count, const FloatBox& middles) {
    bins_ = {};
    for (int i = first; i < first + count; ++i) {
      const FloatBox& item = box(i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(middles.high[axis] > middles.low[axis])) continue;
        const auto bin = static_cast<std::size_t>(binOf(middle(item, axis), axis, middles));
        bins_[axis].boxes[bin].add(item);
        ++bins_[axis].counts[bin];
      }
    }
  }

  void tryAxis(std::size_t axis, int count, Cut& best) const {
    const auto& [boxes, counts] = bins_[axis];
    std::array<float, bins> rightCost{};
    FloatBox right;
    int rightCount = 0;
    for (std::size_t b = bins - 1; b > 0; --b) {
      right.add(boxes[b]);
      rightCount += counts[b];
      rightCost[b - 1] = right.area() * static_cast<float>(rightCount);
    }
    FloatBox left;
    int leftCount = 0;
    for (std::size_t b = 0; b + 1 < bins; ++b) {
      left.add(boxes[b]);
      leftCount += counts[b];
      const float cost = left.area() * static_cast<float>(leftCount) + rightCost[b];
      if (leftCount > 0 && leftCount < count && cost < best.cost) best = {axis, static_cast<int>(b), cost};
    }
  }

  struct Bins {
    std::array<FloatBox, bins> boxes;
    std::array<int, bins> counts{};
  };

  const std::vector<FloatBox>& items_;
  std::array<Bins, 3> bins_;
  std::vector<Node>& nodes_;
  std::vector<int>& order_;
};

RayTree::RayTree(const std::vector<FloatBox>& items) {
  if (!items.empty()) Builder(items, nodes_, order_).run();
}

}  // namespace blossom
