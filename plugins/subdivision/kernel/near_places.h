#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom::subdivision {

/// The nearest of many places, found in a k-d tree (Bentley, CACM 18, 1975).
class NearPlaces {
 public:
  /// Squared distance and number of a place.
  using Near = std::pair<double, std::size_t>;

  /// O(n log n). @param places must outlive the tree
  explicit NearPlaces(std::span<const Vec3> places);

  /// The `count` nearest, nearest first, of equally near ones those with lower numbers. O(log n + count) for places that
  /// are spread over a surface.
  /// @param looked grows by the number of places whose distance was taken
  void nearest(const Vec3& to, std::size_t count, std::vector<Near>& found, std::size_t* looked = nullptr) const;

 private:
  struct Node {
    std::size_t begin = 0, end = 0;  ///< of the order
    std::size_t high = 0;            ///< the node of the upper half; the lower one follows this; 0: a leaf
    Vec3 low = Vec3::Zero(), top = Vec3::Zero();
  };
  std::size_t build(std::size_t begin, std::size_t end);
  struct Search;
  void visit(std::size_t node, Search&) const;

  std::span<const Vec3> places_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace blossom::subdivision
