#include "kernel/rounding/slivers.h"

#include <cmath>

#include "kernel/manifold.h"
#include "kernel/rounding/mean_thickness.h"

namespace blossom::morphology {

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
