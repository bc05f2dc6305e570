#include "kernel/rounding/slivers.h"

#include <cmath>
#include <vector>

#include "kernel/manifold.h"
#include "kernel/rounding/mean_thickness.h"

namespace blossom::morphology {

namespace {

/// The numbers of the faces of each shell.
std::vector<std::vector<std::size_t>> facesOfShells(const MeshTopology& topology) {
  std::vector<std::vector<std::size_t>> faces(topology.components.size());
  for (std::size_t f = 0; f < topology.componentOfFace.size(); ++f)
    faces[static_cast<std::size_t>(topology.componentOfFace[f])].push_back(f);
  return faces;
}

}  // namespace

std::optional<Mesh> withoutSlivers(const Mesh& mesh, const MeshTopology& topology, double thickness, double unit,
                                   const Progress& progress) {
  Mesh result;
  result.points = mesh.points;
  bool isLess = false;
  for (const auto& shell : facesOfShells(topology)) {
    progress.check();
    if (std::abs(meanThickness(mesh, shell, unit)) < thickness)
      isLess = true;
    else
      for (const std::size_t f : shell) result.addFace(mesh.face(f));
  }
  if (!isLess) return std::nullopt;
  return manifoldOf(result, progress);
}

}  // namespace blossom::morphology
