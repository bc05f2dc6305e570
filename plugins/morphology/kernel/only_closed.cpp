#include "kernel/only_closed.h"

#include <utility>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom::morphology {

namespace {

Triangle3 triangleOf(const Mesh& triangles, std::size_t f) {
  const std::vector<Vec3> p = facePoints(triangles, f);
  return {p[0], p[1], p[2]};
}

double edgesOf(const Triangle3& t) { return (t[1] - t[0]).norm() + (t[2] - t[1]).norm() + (t[0] - t[2]).norm(); }

/// What hangs together in a mesh.
struct Part {
  bool isClosed = true;
  double area = 0, edges = 0;  ///< of its triangles, added up
  double largestArea = -1;     ///< of one triangle
  Vec3 middle = Vec3::Zero();  ///< of that one
};

std::vector<Part> partsOf(const Mesh& triangles, const Progress& progress) {
  const MeshTopology topology = meshTopology(triangles, progress);
  std::vector<Part> parts(topology.components.size());
  for (std::size_t c = 0; c < parts.size(); ++c) parts[c].isClosed = topology.components[c].closed;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    Part& part = parts[static_cast<std::size_t>(topology.componentOfFace[f])];
    const Triangle3 t = triangleOf(triangles, f);
    const double own = vectorArea(t).norm();
    part.area += own;
    part.edges += edgesOf(t);
    if (own <= part.largestArea) continue;
    part.largestArea = own;
    part.middle = (t[0] + t[1] + t[2]) / 3;
  }
  return parts;
}

TriangleTree treeOf(const Mesh& triangles) {
  std::vector<Triangle3> all;
  all.reserve(triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) all.push_back(triangleOf(triangles, f));
  return TriangleTree(std::move(all));
}

}  // namespace

bool isOnlyClosed(const Mesh& before, const Mesh& after, double moved, const Progress& progress) {
  const std::vector<Part> parts = partsOf(before, progress);
  double areaBefore = 0, edges = 0;
  for (const Part& part : parts) areaBefore += part.area, edges += part.edges;
  if (area(after) < areaBefore - 2 * moved * edges) return false;
  const TriangleTree there = treeOf(after);
  for (const Part& part : parts) {
    const bool isThin = part.area <= 2 * moved * part.edges;
    if (part.isClosed || isThin) continue;
    const TriangleTree middle({{part.middle, part.middle, part.middle}});
    if (there.closest(middle, progress).distance() > 4 * moved) return false;
  }
  return true;
}

}  // namespace blossom::morphology
