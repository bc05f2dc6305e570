#include "kernel/operations/exact_fit.h"

#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"

namespace blossom::morphology {

namespace {

/// What is left of a solid, as far as it tells an exact fit.
struct Extent {
  std::size_t bodies = 0;
  Bounds bounds;
};

Extent extentOf(const Mesh& left, const Progress& progress) {
  if (left.faceCount() == 0) return {};
  const Mesh apart = manifoldOf(left, progress);
  return {meshTopology(apart, progress).components.size(), bounds(apart)};
}

}  // namespace

bool fitsExactly(Work& work, const Prepared& solid, const Prepared& element, const CommonGrid& grid, const Mesh* known) {
  constexpr double smaller = 1 - 1e-6, farther = 1e-4;  // of the size: far more than an element grows by that
  const Progress& progress = work.progress();
  const auto leftBy = [&](double factor) {
    const auto left = arrangedDifference(termOf(solid), termOf(element, factor), grid.step, progress);
    return extentOf(left ? left->triangles : Mesh(), progress);
  };
  const Extent ofSmaller = leftBy(smaller);
  if (ofSmaller.bodies == 0) return false;
  const Extent ofItself = known ? extentOf(*known, progress) : leftBy(1);
  if (ofItself.bodies != ofSmaller.bodies) return true;
  const double reach = std::max((ofSmaller.bounds.high - ofItself.bounds.high).maxCoeff(),
                                (ofItself.bounds.low - ofSmaller.bounds.low).maxCoeff());
  return reach > farther * ofSmaller.bounds.diagonal();
}

}  // namespace blossom::morphology
