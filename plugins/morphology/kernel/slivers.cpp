#include "kernel/slivers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "kernel/arrangement/numbers.h"
#include "kernel/manifold.h"

namespace blossom::morphology {

namespace {

/// Whether the two sides of each shell on a grid are nearer to each other than a step, on average over its area. In whole
/// numbers: doubles would not know what is left of the volume.
std::vector<bool> shellsThinnerThan(double step, const Mesh& mesh, const MeshTopology& topology) {
  using namespace arrangement;
  struct Sums {
    std::optional<Grid3> corner;  ///< from which volumes are seen
    Whole sixVolumes = 0;
    double twoAreas = 0;
  };
  std::vector<Sums> sums(topology.components.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    Sums& shell = sums[static_cast<std::size_t>(topology.componentOfFace[f])];
    const auto corner = [&](std::size_t k) {
      const Vec3& p = mesh.points[static_cast<std::size_t>(mesh.face(f)[k])];
      return Grid3{std::llround(p[0] / step), std::llround(p[1] / step), std::llround(p[2] / step)};
    };
    const Grid3 first = corner(0);
    if (!shell.corner) shell.corner = first;
    const Normal3 normal = cross(corner(1) - first, corner(2) - first);
    shell.sixVolumes += dot(normal, first - *shell.corner);
    shell.twoAreas +=
        Vec3(static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2])).norm();
  }
  std::vector<bool> isThin;
  isThin.reserve(sums.size());
  for (const Sums& shell : sums)
    isThin.push_back(2 * std::abs(shell.sixVolumes.convert_to<double>()) / 6 < shell.twoAreas / 2);
  return isThin;
}

}  // namespace

Mesh withoutSlivers(Mesh triangles, double step, const Progress& progress) {
  const MeshTopology topology = meshTopology(triangles, progress);
  if (!(step > 0) || topology.components.size() < 2) return triangles;
  const std::vector<bool> isThin = shellsThinnerThan(step, triangles, topology);
  if (std::none_of(isThin.begin(), isThin.end(), [](bool thin) { return thin; })) return triangles;
  Mesh result;
  result.points = triangles.points;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f)
    if (!isThin[static_cast<std::size_t>(topology.componentOfFace[f])]) result.addFace(triangles.face(f));
  return manifoldOf(result, progress);
}

}  // namespace blossom::morphology
