#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "geometry/numeric/box_tree.h"

namespace blossom::subdivision {

/// The nearest of many places.
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
  std::span<const Vec3> places_;
  BoxTree<3> tree_;
};

}  // namespace blossom::subdivision
