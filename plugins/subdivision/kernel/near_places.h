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
  /// Squared distance and number of a place.
  using Near = std::pair<double, std::size_t>;

  /// O(n log n). @param places must outlive the tree
  explicit NearPlaces(std::span<const Vec3> places);

  /// The `count` nearest, nearest first, of equally near ones those with lower numbers. O(log n + count) for places that
  /// are spread over a surface.
  /// @param looked grows by the number of places whose distance was taken
  void nearest(const Vec3& to, std::size_t count, std::vector<Near>& found, std::size_t* looked = nullptr) const;

 private:
  std::span<const Vec3> places_;
  BoxTree<3> tree_;
};

}  // namespace blossom::subdivision
