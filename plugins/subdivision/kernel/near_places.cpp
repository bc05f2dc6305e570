#include "kernel/near_places.h"

#include <algorithm>
#include <numeric>

namespace blossom::subdivision {

/// `found` is a heap with the farthest in front.
struct NearPlaces::Search {
  const Vec3& to;
  std::size_t count;
  std::vector<Near>& found;
  std::size_t looked = 0;

  [[nodiscard]] bool wants(double squaredDistance) const {
    return found.size() < count || squaredDistance <= found.front().first;
  }
  void offer(const Near& near) {
    ++looked;
    if (found.size() == count) {
      if (!(near < found.front())) return;
      std::pop_heap(found.begin(), found.end());
      found.pop_back();
    }
    found.push_back(near);
    std::push_heap(found.begin(), found.end());
  }
};

NearPlaces::NearPlaces(std::span<const Vec3> places) : places_(places), order_(places.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!places.empty()) build(0, places.size());
}

std::size_t NearPlaces::build(std::size_t begin, std::size_t end) {
  constexpr std::size_t leaf = 12;
  const std::size_t number = nodes_.size();
  Node made{begin, end, 0, places_[order_[begin]], places_[order_[begin]]};
  for (std::size_t i = begin; i < end; ++i) {
    made.low = made.low.cwiseMin(places_[order_[i]]);
    made.top = made.top.cwiseMax(places_[order_[i]]);
  }
  nodes_.push_back(made);
  if (end - begin <= leaf) return number;
  Eigen::Index axis = 0;
  (made.top - made.low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&](std::size_t a, std::size_t b) { return places_[a][axis] < places_[b][axis]; });
  build(begin, middle);
  const std::size_t high = build(middle, end);
  nodes_[number].high = high;
  return number;
}

void NearPlaces::visit(std::size_t number, Search& search) const {
  const Node& node = nodes_[number];
  if (node.high == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i)
      search.offer({(places_[order_[i]] - search.to).squaredNorm(), order_[i]});
    return;
  }
  const auto outside = [&](const Node& n) { return (search.to - search.to.cwiseMax(n.low).cwiseMin(n.top)).squaredNorm(); };
  std::size_t near = number + 1, far = node.high;
  double toNear = outside(nodes_[near]), toFar = outside(nodes_[far]);
  if (toFar < toNear) {
    std::swap(near, far);
    std::swap(toNear, toFar);
  }
  if (search.wants(toNear)) visit(near, search);
  if (search.wants(toFar)) visit(far, search);
}

void NearPlaces::nearest(const Vec3& to, std::size_t count, std::vector<Near>& found, std::size_t* looked) const {
  found.clear();
  Search search{to, std::min(count, places_.size()), found};
  if (search.count > 0) visit(0, search);
  std::sort_heap(found.begin(), found.end());
  if (looked) *looked += search.looked;
}

}  // namespace blossom::subdivision
