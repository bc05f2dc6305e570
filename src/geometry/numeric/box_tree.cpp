#include "geometry/numeric/box_tree.h"

#include <algorithm>

namespace blossom {

template <int N>
struct BoxTree<N>::Builder {
  /// An item with twice its centre along the axis that is halved.
  struct Place {
    double twiceCentre;
    std::uint32_t item;
  };
  std::span<const Box> boxes;
  std::vector<Place> places;
  std::vector<Node>& nodes;
  std::size_t leafSize;
  const Progress& progress;

  void build(std::uint32_t first, std::uint32_t count) {
    constexpr std::uint32_t many = 1024;
    if (count > many) progress.check();
    const std::size_t index = nodes.size();
    nodes.push_back(nodeOver(first, count));
    if (count <= leafSize) return;
    Eigen::Index axis = 0;
    nodes.back().box.sizes().maxCoeff(&axis);
    const auto begin = places.begin() + first, end = begin + count;
    std::for_each(begin, end, [&](Place& place) {
      const Box& box = boxes[place.item];
      place.twiceCentre = box.min()[axis] + box.max()[axis];
    });
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [](const Place& a, const Place& b) { return a.twiceCentre < b.twiceCentre; });
    build(first, half);
    nodes[index].right = static_cast<std::uint32_t>(nodes.size());
    build(first + half, count - half);
  }

  [[nodiscard]] Node nodeOver(std::uint32_t first, std::uint32_t count) const {
    Node node;
    node.first = first;
    node.count = count;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::uint32_t item = places[i].item;
      node.box.extend(boxes[item]);
      node.last = std::max(node.last, item);
    }
    return node;
  }
};

template <int N>
BoxTree<N>::BoxTree(std::span<const Box> boxes, std::size_t leafSize, const Progress& progress) {
  if (boxes.empty()) return;
  Builder builder{boxes, std::vector<typename Builder::Place>(boxes.size()), nodes_, leafSize, progress};
  for (std::size_t i = 0; i < boxes.size(); ++i) builder.places[i].item = static_cast<std::uint32_t>(i);
  nodes_.reserve(2 * boxes.size() / leafSize + 1);
  builder.build(0, static_cast<std::uint32_t>(boxes.size()));
  order_.reserve(boxes.size());
  for (const auto& place : builder.places) order_.push_back(place.item);
}

template class BoxTree<2>;
template class BoxTree<3>;

}  // namespace blossom
