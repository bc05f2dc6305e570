#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace blossom::subdivision {

/// k-d tree of points for nearest-neighbour searches (Bentley, CACM 18, 1975).
class NearPlaces {
 public:
  /// Squared distance and index of a point.
  using Near = std::pair<double, std::size_t>;

  /// O(n log n). @param places must outlive the tree
  explicit NearPlaces(std::span<const Vec3> places);

  /// The `count` nearest points in order; equally near ones by index. O(log n + count) for points distributed over a
  /// surface.
  /// @param looked increased by the number of computed distances
  void nearest(const Vec3& to, std::size_t count, std::vector<Near>& found, std::size_t* looked = nullptr) const;

 private:
  struct Node {
    std::size_t begin = 0, end = 0;  ///< range in order_
    std::size_t high = 0;            ///< node of the upper half; that of the lower half follows this node; 0: a leaf
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
