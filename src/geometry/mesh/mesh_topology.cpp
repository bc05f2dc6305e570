#include "geometry/mesh/mesh_topology.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "geometry/mesh/polygon_triangulation.h"
#include "geometry/numeric/union_find.h"

namespace blossom {
namespace {

struct HalfEdge {
  int low, high;
  bool forward;
  int face;
  int corner;  ///< where it starts
};

/// Sorted by their vertices, those of one edge in the order given: counted by the lower vertex, at which few begin.
std::vector<HalfEdge> sortedByEnds(const std::vector<HalfEdge>& halfEdges, std::size_t vertices) {
  std::vector<std::size_t> firsts(vertices + 1, 0);
  for (const HalfEdge& half : halfEdges) ++firsts[static_cast<std::size_t>(half.low) + 1];
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  std::vector<HalfEdge> sorted(halfEdges.size());
  std::vector<std::size_t> next(firsts.begin(), firsts.end() - 1);
  for (const HalfEdge& half : halfEdges) sorted[next[static_cast<std::size_t>(half.low)]++] = half;
  const auto at = [&](std::size_t k) { return sorted.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(at(firsts[v]), at(firsts[v + 1]),
              [](const HalfEdge& a, const HalfEdge& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
  return sorted;
}

std::vector<HalfEdge> sortedHalfEdges(const Mesh& mesh, const Progress& progress) {
  std::vector<HalfEdge> result;
  result.reserve(mesh.faceVertices.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 65536 == 0) progress.check();
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int from = face[k];
      const int to = face[(k + 1) % face.size()];
      if (from < 0 || static_cast<std::size_t>(from) >= mesh.points.size())
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("Face {} of the mesh names the vertex {}, but there are {}.", f, from, mesh.points.size()));
      if (from == to) continue;
      result.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<int>(f),
                        mesh.faceStarts[f] + static_cast<int>(k)});
    }
  }
  return sortedByEnds(result, mesh.points.size());
}

std::vector<MeshEdge> edgesOf(const std::vector<HalfEdge>& halfEdges) {
  std::vector<MeshEdge> edges;
  for (const HalfEdge& half : halfEdges) {
    if (edges.empty() || edges.back().low != half.low || edges.back().high != half.high)
      edges.push_back({half.low, half.high});
    MeshEdge& edge = edges.back();
    const auto place = static_cast<std::size_t>(edge.forward) + static_cast<std::size_t>(edge.backward);
    if (place < 2) {
      edge.faces[place] = half.face;
      edge.corners[place] = half.corner;
    }
    ++(half.forward ? edge.forward : edge.backward);
  }
  return edges;
}

int nextCorner(const Mesh& mesh, int face, int corner) {
  const auto f = static_cast<std::size_t>(face);
  return corner + 1 < mesh.faceStarts[f + 1] ? corner + 1 : mesh.faceStarts[f];
}

/// Corners around a vertex are one fan when they are linked through edges with two faces.
UnionFind fansOf(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  UnionFind fans(mesh.faceVertices.size());
  for (const MeshEdge& edge : edges) {
    if (!edge.manifold()) continue;
    const auto [a, b] = edge.corners;
    fans.unite(static_cast<std::size_t>(a), static_cast<std::size_t>(nextCorner(mesh, edge.faces[1], b)));
    fans.unite(static_cast<std::size_t>(b), static_cast<std::size_t>(nextCorner(mesh, edge.faces[0], a)));
  }
  return fans;
}

void findComponents(const Mesh& mesh, const std::vector<HalfEdge>& halfEdges, MeshTopology& topology) {
  UnionFind faces(mesh.faceCount());
  for (const MeshEdge& edge : topology.edges)
    if (edge.manifold()) faces.unite(static_cast<std::size_t>(edge.faces[0]), static_cast<std::size_t>(edge.faces[1]));

  topology.componentOfFace.assign(mesh.faceCount(), -1);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::size_t root = faces.find(f);
    if (root == f) {
      topology.componentOfFace[f] = static_cast<int>(topology.components.size());
      topology.components.emplace_back();
    }
    topology.componentOfFace[f] = topology.componentOfFace[root];
    ++topology.components[static_cast<std::size_t>(topology.componentOfFace[f])].faces;
  }
  const auto componentOf = [&](int face) -> MeshComponent& {
    return topology.components[static_cast<std::size_t>(topology.componentOfFace[static_cast<std::size_t>(face)])];
  };
  std::size_t i = 0;
  for (const MeshEdge& edge : topology.edges) {
    for (; i < halfEdges.size() && halfEdges[i].low == edge.low && halfEdges[i].high == edge.high; ++i) {
      MeshComponent& component = componentOf(halfEdges[i].face);
      ++component.halfEdges;
      component.closed = component.closed && edge.balanced();
    }
  }
  UnionFind fans = fansOf(mesh, topology.edges);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    for (int c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c)
      if (fans.find(static_cast<std::size_t>(c)) == static_cast<std::size_t>(c)) ++componentOf(static_cast<int>(f)).fans;
}

}  // namespace

int MeshComponent::genus() const {
  const auto characteristic =
      static_cast<long long>(fans) - static_cast<long long>(halfEdges / 2) + static_cast<long long>(faces);
  return static_cast<int>((2 - characteristic) / 2);
}

bool MeshTopology::closed() const {
  return !components.empty() &&
         std::all_of(components.begin(), components.end(), [](const MeshComponent& c) { return c.closed; });
}

MeshTopology meshTopology(const Mesh& mesh, const Progress& progress) {
  MeshTopology topology;
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh, progress);
  topology.edges = edgesOf(halfEdges);
  progress.check();
  findComponents(mesh, halfEdges, topology);
  return topology;
}

std::vector<Vec3> facePoints(const Mesh& mesh, std::size_t f) {
  std::vector<Vec3> points;
  for (const int vertex : mesh.face(f)) points.push_back(mesh.points[static_cast<std::size_t>(vertex)]);
  return points;
}

std::pair<Mesh, std::vector<int>> triangulated(const Mesh& mesh, const Progress& progress) {
  std::pair<Mesh, std::vector<int>> result;
  result.first.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 65536 == 0) progress.check();
    const auto face = mesh.face(f);
    if (face.size() < 3) continue;
    for (const auto& triangle : triangulate(facePoints(mesh, f), progress)) {
      const std::array<int, 3> vertices{face[static_cast<std::size_t>(triangle[0])],
                                        face[static_cast<std::size_t>(triangle[1])],
                                        face[static_cast<std::size_t>(triangle[2])]};
      result.first.addFace(vertices);
      result.second.push_back(static_cast<int>(f));
    }
  }
  return result;
}

double signedVolume(const Mesh& mesh) {
  if (mesh.points.empty()) return 0;
  const Vec3 reference = std::accumulate(mesh.points.begin(), mesh.points.end(), Vec3(0, 0, 0),
                                         [](const Vec3& a, const Vec3& b) -> Vec3 { return a + b; }) /
                         static_cast<double>(mesh.points.size());
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto v = mesh.face(f);
    const auto at = [&](std::size_t k) -> Vec3 { return mesh.points[static_cast<std::size_t>(v[k])] - reference; };
    sum += at(0).dot(at(1).cross(at(2)));
  }
  return sum / 6;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto v = mesh.face(f);
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(v[k])]; };
    sum += (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  return sum / 2;
}

}  // namespace blossom
