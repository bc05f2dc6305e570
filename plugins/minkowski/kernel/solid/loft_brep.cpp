#include "kernel/solid/loft_brep.h"

#include <cmath>
#include <optional>
#include <variant>

#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/joined_faces.h"
#include "geometry/occt/occt.h"

namespace blossom::minkowski {
namespace {

std::optional<double> volumeOf(const Brep& solid, const Progress& progress) {
  for (const Measure& each : measure(Shape(solid), progress).values)
    if (const double* volume = std::get_if<double>(&each.value); volume && each.name == "volume") return *volume;
  return std::nullopt;
}

}  // namespace

Brep loftBrep(const Mesh& mesh, const Progress& progress) {
  Brep apart(toShape(mesh));
  progress.check();
  // Of a shape of its own, for joining changes what is shared.
  const TopoDS_Shape together = withJoinedFaces(toShape(mesh), JoinedEdges::Stay);
  if (together.IsNull()) return apart;
  Brep result(together);
  const double volume = signedVolume(triangulated(mesh, progress).first);
  constexpr double rounding = 1e-6;
  const std::optional<double> left = volumeOf(result, progress);
  return left && std::abs(*left - volume) <= rounding * std::abs(volume) ? result : apart;
}

}  // namespace blossom::minkowski
