#include "kernel/rounding/kept.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/polygon_triangulation.h"
#include "geometry/mesh/triangle_distance.h"

namespace blossom::morphology {

namespace {

Triangle3 triangleOf(const Mesh& triangles, std::size_t f) {
  const std::vector<Vec3> p = facePoints(triangles, f);
  return {p[0], p[1], p[2]};
}

double edgesOf(const Triangle3& t) { return (t[1] - t[0]).norm() + (t[2] - t[1]).norm() + (t[0] - t[2]).norm(); }

/// The area of strips along all edges.
double stripsOf(const Mesh& triangles, double width) {
  double edges = 0;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) edges += edgesOf(triangleOf(triangles, f));
  return width * edges;
}

/// What hangs together in a mesh.
struct Part {
  bool isClosed = true;
  double area = 0, edges = 0;  ///< of its triangles, added up
};

std::vector<Part> partsOf(const Mesh& triangles, const MeshTopology& topology) {
  std::vector<Part> parts(topology.components.size());
  for (std::size_t c = 0; c < parts.size(); ++c) parts[c].isClosed = topology.components[c].closed;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    Part& part = parts[static_cast<std::size_t>(topology.componentOfFace[f])];
    const Triangle3 t = triangleOf(triangles, f);
    part.area += vectorArea(t).norm();
    part.edges += edgesOf(t);
  }
  return parts;
}

TriangleTree treeOf(const Mesh& triangles) {
  std::vector<Triangle3> all;
  all.reserve(triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) all.push_back(triangleOf(triangles, f));
  return TriangleTree(std::move(all));
}

/// Of its vertices, edges and faces: 2 for each body without holes through it.
std::ptrdiff_t eulerNumber(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<int> used = mesh.faceVertices;
  std::sort(used.begin(), used.end());
  const auto vertices = std::unique(used.begin(), used.end()) - used.begin();
  return vertices - std::ssize(topology.edges) + static_cast<std::ptrdiff_t>(mesh.faceCount());
}

/// Of a polygon whose corners all turn one way, once around: no triangles of it fold.
bool isConvex(const Mesh& mesh, std::span<const int> face, const Vec3& normal) {
  const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(face[k % face.size()])]; };
  const auto turns = [&](const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).dot(normal); };
  const Vec3 first = at(1) - at(0);
  int turnsBack = 0;  // of the way along the first side
  for (std::size_t k = 0; k < face.size(); ++k) {
    if (!(turns(at(k), at(k + 1), at(k + 2)) > 0) || turns(at(0), at(k), at(k + 1)) < 0) return false;
    if ((at(k + 1) - at(k)).dot(first) >= 0 && (at(k + 2) - at(k + 1)).dot(first) < 0) ++turnsBack;
  }
  return turnsBack == 1;
}

double perimeterOf(std::span<const Vec3> polygon) {
  double sum = (polygon.front() - polygon.back()).norm();
  for (std::size_t k = 1; k < polygon.size(); ++k) sum += (polygon[k] - polygon[k - 1]).norm();
  return sum;
}

}  // namespace

bool foldsBack(const Mesh& polygons, double size, double moved, const Progress& progress) {
  for (std::size_t f = 0; f < polygons.faceCount(); ++f) {
    if (f % 1024 == 0) progress.check();
    const auto face = polygons.face(f);
    if (face.size() < 4) continue;
    const std::vector<Vec3> corners = facePoints(polygons, f);
    const Vec3 normal = vectorArea(corners);
    if (isConvex(polygons, face, normal)) continue;
    double sum = 0;
    for (const auto& [a, b, c] : triangulate(corners, progress)) {
      const auto at = [&](int k) -> const Vec3& { return corners[static_cast<std::size_t>(k)]; };
      sum += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
    }
    if (sum > normal.norm() + 2 * moved * perimeterOf(corners) + 1e-13 * size * size) return true;
  }
  return false;
}

bool keepsVolume(const Mesh& before, const Mesh& after, double size, double moved, const Progress& progress) {
  const Mesh triangles = triangulated(after, progress).first;
  const double areaBefore = area(before), roundOff = 1e-13 * size * size;
  if (std::abs(signedVolume(triangles) - signedVolume(before)) > 2 * moved * areaBefore + roundOff * size) return false;
  return area(triangles) <= areaBefore + stripsOf(before, 2 * moved) + stripsOf(triangles, 2 * moved) + roundOff;
}

bool losesDetails(const Mesh& before, const Mesh& after, double size, double moved, const Progress& progress) {
  const Mesh triangles = triangulated(after, progress).first;
  const MeshTopology first = meshTopology(before, progress), last = meshTopology(triangles, progress);
  if (last.components.size() < first.components.size() || eulerNumber(before, first) != eulerNumber(triangles, last))
    return true;
  return area(triangles) < area(before) - stripsOf(before, 2 * moved) - 1e-13 * size * size;
}

bool keepsPlaces(const Mesh& before, const Mesh& after, double moved, bool isLossTold, const Progress& progress) {
  constexpr double reach = 8;  // joined faces may lie beside what they join by some of the steps of their corners
  const MeshTopology topology = meshTopology(before, progress);
  const std::vector<Part> parts = partsOf(before, topology);
  const TriangleTree there = treeOf(after);
  const auto isThere = [&](const Vec3& p) {
    return there.closest(TriangleTree({{p, p, p}}), progress).distance() <= reach * moved;
  };
  std::vector<bool> isAsked(before.points.size(), false);
  const auto isCornerThere = [&](int corner) {
    const auto k = static_cast<std::size_t>(corner);
    if (isAsked[k]) return true;
    isAsked[k] = true;
    return isThere(before.points[k]);
  };
  for (std::size_t f = 0; f < before.faceCount(); ++f) {
    progress.check();
    const Part& part = parts[static_cast<std::size_t>(topology.componentOfFace[f])];
    const bool isThin = part.area <= 2 * moved * part.edges;
    if (isThin && (!part.isClosed || isLossTold)) continue;
    const auto corners = before.face(f);
    const Triangle3 t = triangleOf(before, f);
    if (!isThere((t[0] + t[1] + t[2]) / 3) || !std::all_of(corners.begin(), corners.end(), isCornerThere)) return false;
  }
  return true;
}

}  // namespace blossom::morphology
