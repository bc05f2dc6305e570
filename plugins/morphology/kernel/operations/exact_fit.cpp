#include "kernel/operations/exact_fit.h"

#include <algorithm>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"

namespace blossom::morphology {

namespace {

/// Of each body that is left.
std::vector<Bounds> extentsOf(const Mesh& left, const Progress& progress) {
  if (left.faceCount() == 0) return {};
  const Mesh apart = manifoldOf(left, progress);
  const MeshTopology topology = meshTopology(apart, progress);
  std::vector<Bounds> extents(topology.components.size());
  for (std::size_t f = 0; f < apart.faceCount(); ++f)
    for (const int v : apart.face(f))
      extents[static_cast<std::size_t>(topology.componentOfFace[f])].add(apart.points[static_cast<std::size_t>(v)]);
  return extents;
}

bool areNear(const Bounds& a, const Bounds& b, double distance) {
  return (a.low - b.low).cwiseAbs().maxCoeff() <= distance && (a.high - b.high).cwiseAbs().maxCoeff() <= distance;
}

}  // namespace

bool fitsExactly(Work& work, const Prepared& solid, const Prepared& element, const CommonGrid& grid, const Mesh* known) {
  constexpr double smaller = 1 - 1e-6, farther = 1e-4;  // of the size: far more than what is left grows by that
  const Progress& progress = work.progress();
  const auto leftBy = [&](double factor) {
    const auto left = arrangedDifference(termOf(solid), termOf(element, factor), grid.step, progress);
    return extentsOf(left ? left->triangles : Mesh(), progress);
  };
  const std::vector<Bounds> ofSmaller = leftBy(smaller);
  if (ofSmaller.empty()) return false;
  const std::vector<Bounds> ofItself = known ? extentsOf(*known, progress) : leftBy(1);
  const double distance = farther * solid.bounds.diagonal();
  return !std::all_of(ofSmaller.begin(), ofSmaller.end(), [&](const Bounds& body) {
    return std::any_of(ofItself.begin(), ofItself.end(),
                       [&](const Bounds& other) { return areNear(body, other, distance); });
  });
}

}  // namespace blossom::morphology
