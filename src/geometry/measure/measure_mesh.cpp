#include <algorithm>
#include <cmath>

#include "geometry/measure/measure_parts.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom {
namespace {

/// Components that are no walls of voids: closed ones that look inwards, beside others that look outwards.
std::size_t countBodies(const MeshTopology& topology, const Mesh& triangles, const std::vector<int>& faceOf) {
  std::vector<double> volumes(topology.components.size());
  for (std::size_t t = 0; t < faceOf.size(); ++t) {
    const auto corner = [&](std::size_t k) -> Vec3 {
      const auto& points = triangles.points;
      return points[static_cast<std::size_t>(triangles.faceVertices[3 * t + k])] - points.front();
    };
    const auto component = topology.componentOfFace[static_cast<std::size_t>(faceOf[t])];
    volumes[static_cast<std::size_t>(component)] += corner(0).dot(corner(1).cross(corner(2)));
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
