#include "kernel/coplanar_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace blossom::morphology {

namespace {

std::size_t asIndex(int index) { return static_cast<std::size_t>(index); }

/// Of triangles, twice as long as they have area.
std::vector<Vec3> normalsOf(const Mesh& triangles) {
  std::vector<Vec3> normals;
  normals.reserve(triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto face = triangles.face(f);
    const Vec3& first = triangles.points[asIndex(face[0])];
    normals.push_back((triangles.points[asIndex(face[1])] - first).cross(triangles.points[asIndex(face[2])] - first));
  }
  return normals;
}

class Regions {
 public:
  Regions(const Mesh& mesh, const MeshTopology& topology, double tolerance) : mesh_(mesh), tolerance_(tolerance) {
    neighbours_.resize(mesh.faceVertices.size(), -1);
    for (const MeshEdge& edge : topology.edges)
      if (edge.manifold()) {
        neighbours_[asIndex(edge.corners[0])] = edge.faces[1];
        neighbours_[asIndex(edge.corners[1])] = edge.faces[0];
      }
    normals_ = normalsOf(mesh);
    regionOfFace_.assign(mesh.faceCount(), -1);
    std::vector<std::size_t> order(mesh.faceCount());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The largest triangle knows its plane best.
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return normals_[a].squaredNorm() > normals_[b].squaredNorm(); });
    for (const std::size_t seed : order)
      if (regionOfFace_[seed] < 0) grow(static_cast<int>(seed));
  }
  [[nodiscard]] CoplanarRegions made() && { return {std::move(regionOfFace_), count_}; }

 private:
  void grow(int seed) {
    const int region = static_cast<int>(count_++);
    const Vec3 normal = normals_[asIndex(seed)].normalized(), origin = mesh_.points[asIndex(mesh_.face(asIndex(seed))[0])];
    regionOfFace_[asIndex(seed)] = region;
    std::vector<int> open{seed};
    while (!open.empty()) {
      const int face = open.back();
      open.pop_back();
      for (int side = mesh_.faceStarts[asIndex(face)]; side < mesh_.faceStarts[asIndex(face) + 1]; ++side) {
        const int next = neighbours_[asIndex(side)];
        if (next < 0 || regionOfFace_[asIndex(next)] >= 0 || !liesIn(next, origin, normal)) continue;
        regionOfFace_[asIndex(next)] = region;
        open.push_back(next);
      }
    }
  }
  [[nodiscard]] bool liesIn(int face, const Vec3& origin, const Vec3& normal) const {
    const auto corners = mesh_.face(asIndex(face));
    const auto near = [&](int v) { return std::abs((mesh_.points[asIndex(v)] - origin).dot(normal)) <= tolerance_; };
    if (!std::all_of(corners.begin(), corners.end(), near)) return false;
    // The normal of a sliver is chance.
    return normals_[asIndex(face)].dot(normal) > 0 || normals_[asIndex(face)].norm() <= tolerance_ * longestSide(face);
  }
  [[nodiscard]] double longestSide(int face) const {
    const auto p = facePoints(mesh_, asIndex(face));
    return std::max({(p[0] - p[1]).norm(), (p[1] - p[2]).norm(), (p[2] - p[0]).norm()});
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<int> neighbours_;  ///< beyond the side that begins at each corner of a face; -1: none, or several
  std::vector<Vec3> normals_;
  std::size_t count_ = 0;
  std::vector<int> regionOfFace_;
};

}  // namespace

CoplanarRegions coplanarRegions(const Mesh& triangles, const MeshTopology& topology, double tolerance) {
  return Regions(triangles, topology, tolerance).made();
}

}  // namespace blossom::morphology
