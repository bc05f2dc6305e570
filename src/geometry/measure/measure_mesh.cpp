#include <algorithm>
#include <cmath>

#include "geometry/measure/measure_parts.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom {

Measures measureMesh(const Mesh& mesh, const Progress& progress) {
  const MeshTopology topology = meshTopology(mesh, progress);
  const Mesh triangles = triangulated(mesh, progress).first;
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
  measures.values.push_back(countMeasure("components", topology.components.size()));
  measures.values.push_back({"closed", topology.closed()});
  return measures;
}

}  // namespace blossom
