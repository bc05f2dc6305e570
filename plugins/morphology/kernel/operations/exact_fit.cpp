#include "kernel/operations/exact_fit.h"

#include <algorithm>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"

namespace blossom::morphology {

namespace {

std::vector<Triangle3> trianglesOf(const Mesh& mesh) {
  std::vector<Triangle3> triangles;
  triangles.reserve(mesh.faceCount());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(face[i])]; };
    triangles.push_back({at(0), at(1), at(2)});
  }
  return triangles;
}

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

/// Whether a corner or the middle of a triangle lies farther than `distance` from all of the other triangles, as those of a
/// sheet do that goes where nothing else does.
bool reachesFarther(const Mesh& mesh, const Mesh& other, double distance, const Progress& progress) {
  const TriangleTree tree(trianglesOf(other));
  for (const Triangle3& t : trianglesOf(mesh)) {
    progress.check();
    for (const Vec3& p : {t[0], t[1], t[2], Vec3((t[0] + t[1] + t[2]) / 3)})
      if (TriangleTree({Triangle3{p, p, p}}).closest(tree, progress).distance() > distance) return true;
  }
  return false;
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
    return left ? left->triangles : Mesh();
  };
  const Mesh bySmaller = leftBy(smaller);
  if (bySmaller.faceCount() == 0) return false;
  const Mesh byItself = known ? *known : leftBy(1);
  const std::vector<Bounds> ofSmaller = extentsOf(bySmaller, progress), ofItself = extentsOf(byItself, progress);
  const double distance = farther * solid.bounds.diagonal();
  if (ofItself.empty() || reachesFarther(bySmaller, byItself, distance, progress)) return true;
  return !std::all_of(ofSmaller.begin(), ofSmaller.end(), [&](const Bounds& body) {
    return std::any_of(ofItself.begin(), ofItself.end(),
                       [&](const Bounds& other) { return areNear(body, other, distance); });
  });
}

}  // namespace blossom::morphology
