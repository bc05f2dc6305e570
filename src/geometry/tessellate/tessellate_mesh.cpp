#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/mesh/discrete_curvature.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/polygon_triangulation.h"
#include "geometry/numeric/union_find.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

/// Edges that turn more than 30 degrees are sharp.
const double sharpCosine = std::cos(std::numbers::pi / 6);

class MeshTessellator {
 public:
  MeshTessellator(const Mesh& mesh, const TessellationOptions& options, const Progress& progress)
      : mesh_(mesh), curvature_(options.curvature), progress_(progress), topology_(meshTopology(mesh, progress)) {}

  Tessellation run() {
    findFaceNormals();
    findSharpEdges();
    addPoints();
    addTriangles();
    if (curvature_) result_.curvatures = discreteCurvature(result_.points, result_.normals, result_.triangles, progress_);
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const MeshEdge& edge = topology_.edges[e];
      if (sharp_[e]) result_.edges.push_back({point(edge.low), point(edge.high)});
    }
    result_.edgeIndices.assign(result_.edges.size(), -1);
    result_.vertices = mesh_.points;
    if (mesh_.faceCount() == 0) result_.markers = mesh_.points;  // a cloud of points
    if (mesh_.color) result_.faceColors.assign(mesh_.faceCount(), *mesh_.color);
    return std::move(result_);
  }

 private:
  const Vec3& point(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

  void findFaceNormals() {
    faceNormals_.reserve(mesh_.faceCount());
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) faceNormals_.push_back(vectorArea(facePoints(mesh_, f)));
  }

  bool turnsSharply(const MeshEdge& edge) const {
    const Vec3& a = faceNormals_[static_cast<std::size_t>(edge.faces[0])];
    const Vec3& b = faceNormals_[static_cast<std::size_t>(edge.faces[1])];
    return a.dot(b) < sharpCosine * a.norm() * b.norm();
  }

  void findSharpEdges() {
    std::vector<std::pair<int, int>> creased;
    for (const Crease& crease : mesh_.creases)
      if (crease.sharpness > 0) creased.emplace_back(std::min(crease.from, crease.to), std::max(crease.from, crease.to));
    std::sort(creased.begin(), creased.end());
    for (const MeshEdge& edge : topology_.edges)
      sharp_.push_back(!edge.manifold() || turnsSharply(edge) ||
                       std::binary_search(creased.begin(), creased.end(), std::pair(edge.low, edge.high)));
  }

  std::size_t cornerAfter(int face, int corner) const {
    const auto f = static_cast<std::size_t>(face);
    return static_cast<std::size_t>(corner + 1 < mesh_.faceStarts[f + 1] ? corner + 1 : mesh_.faceStarts[f]);
  }

  /// Corners that meet over a smooth edge share a point and a normal; over a sharp edge, and of flat faces, they part.
  void addPoints() {
    UnionFind corners(mesh_.faceVertices.size());
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      if (sharp_[e] || mesh_.flatFaces) continue;
      const MeshEdge& edge = topology_.edges[e];
      const auto [a, b] = edge.corners;
      corners.unite(static_cast<std::size_t>(a), cornerAfter(edge.faces[1], b));
      corners.unite(static_cast<std::size_t>(b), cornerAfter(edge.faces[0], a));
    }
    pointOfCorner_.assign(mesh_.faceVertices.size(), -1);
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      if (f % 65536 == 0) progress_.check();
      for (auto c = static_cast<std::size_t>(mesh_.faceStarts[f]); c < static_cast<std::size_t>(mesh_.faceStarts[f + 1]);
           ++c) {
        int& root = pointOfCorner_[corners.find(c)];
        if (root < 0) {
          root = static_cast<int>(result_.points.size());
          result_.points.push_back(point(mesh_.faceVertices[c]));
          result_.normals.push_back(Vec3::Zero());
        }
        pointOfCorner_[c] = root;
        result_.normals[static_cast<std::size_t>(root)] += faceNormals_[f];  // weighted by area
      }
    }
    for (Vec3& normal : result_.normals) normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(0, 0, 1);
  }

  void addTriangles() {
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      if (f % 65536 == 0) progress_.check();
      const auto corner = [&](int k) {
        return pointOfCorner_[static_cast<std::size_t>(mesh_.faceStarts[f]) + static_cast<std::size_t>(k)];
      };
      for (const auto& [a, b, c] : triangulate(facePoints(mesh_, f), progress_)) {
        result_.triangles.push_back({corner(a), corner(b), corner(c)});
        result_.faceOfTriangle.push_back(static_cast<int>(f));
      }
    }
  }

  const Mesh& mesh_;
  const bool curvature_;
  const Progress& progress_;
  MeshTopology topology_;
  std::vector<Vec3> faceNormals_;
  std::vector<bool> sharp_;
  std::vector<int> pointOfCorner_;
  Tessellation result_;
};

}  // namespace

Tessellation tessellateMesh(const Mesh& mesh, const TessellationOptions& options, const Progress& progress) {
  return MeshTessellator(mesh, options, progress).run();
}

}  // namespace blossom
