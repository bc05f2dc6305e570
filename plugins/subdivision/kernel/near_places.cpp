#include "kernel/near_places.h"

#include <algorithm>

namespace blossom::subdivision {

namespace {

BoxTree<3> treeOver(std::span<const Vec3> places) {
  constexpr std::size_t leafSize = 12;
  std::vector<Box3> boxes(places.begin(), places.end());
  return BoxTree<3>(boxes, leafSize);
}

}  // namespace

NearPlaces::NearPlaces(std::span<const Vec3> places) : places_(places), tree_(treeOver(places)) {}

void NearPlaces::nearest(const Vec3& to, std::size_t count, std::vector<Near>& found, std::size_t* looked) const {
  found.clear();  // a heap with the farthest in front
  const std::size_t most = std::min(count, places_.size());
  const auto offer = [&](std::size_t place) {
    const Near near((places_[place] - to).squaredNorm(), place);
    if (looked) ++*looked;
    if (found.size() == most) {
      if (!(near < found.front())) return;
      std::pop_heap(found.begin(), found.end());
      found.pop_back();
    }
    found.push_back(near);
    std::push_heap(found.begin(), found.end());
  };
  if (most > 0)
    tree_.walk([&](const Box3& box) { return squaredDistance(box, to); }, offer,
               [&](double squaredDistance) { return found.size() < most || squaredDistance <= found.front().first; });
  std::sort_heap(found.begin(), found.end());
}

}  // namespace blossom::subdivision
