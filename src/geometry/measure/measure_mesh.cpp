#include <algorithm>
#include <cmath>

#include "geometry/measure/measure_parts.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom {
namespace {

/// Components that are no walls of voids: closed ones that look inwards, beside others that look outwards.
std::size_t countBodies(const MeshTopology& topology, const Mesh& triangles, const std::vector<int>& faceOf) {
  std::vector<double> volumes(topology.components.size());
  std::vector<int> origins(topology.components.size(), -1);  // of each, one of its own points: others may lie far away
  for (std::size_t t = 0; t < faceOf.size(); ++t) {
    const auto component = static_cast<std::size_t>(topology.componentOfFace[static_cast<std::size_t>(faceOf[t])]);
    const auto* const corners = &triangles.faceVertices[3 * t];
    if (origins[component] < 0) origins[component] = corners[0];
    const auto at = [&](int v) { return triangles.points[static_cast<std::size_t>(v)]; };
    const Vec3 origin = at(origins[component]);
    volumes[component] += (at(corners[0]) - origin).dot((at(corners[1]) - origin).cross(at(corners[2]) - origin));
  }
  std::size_t walls = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    if (topology.components[c].closed && volumes[c] < 0) ++walls;
  return walls < volumes.size() ? volumes.size() - walls : volumes.size();
}

}  // namespace

Measures measureMesh(const Mesh& mesh, const Progress& progress) {
  const MeshTopology topology = meshTopology(mesh, progress);
  const auto [triangles, faceOf] = triangulated(mesh, progress);
  int genus = 0;
  for (const MeshComponent& component : topology.components)
    if (component.closed) genus += component.genus();

  Measures measures{"mesh", {}};
  if (topology.closed()) measures.values.push_back({"volume", signedVolume(triangles), MeasureUnit::Volume});
  measures.values.push_back({"area", area(triangles), MeasureUnit::Area});
  measures.values.push_back(countMeasure("faces", mesh.faceCount()));
  measures.values.push_back(countMeasure("vertices", mesh.points.size()));
  measures.values.push_back(countMeasure("edges", topology.edges.size()));
  measures.values.push_back({"genus", static_cast<std::int64_t>(genus)});
  measures.values.push_back(countMeasure("components", countBodies(topology, triangles, faceOf)));
  measures.values.push_back(countMeasure("shells", topology.components.size()));
  measures.values.push_back({"closed", topology.closed()});
  return measures;
}

}  // namespace blossom
