#pragma once
#include <array>
#include <limits>
#include <vector>

#include "scene/picking.h"
#include "scene/ray_tree.h"

/// Inside of PickIndex.
namespace blossom {

/// Implementation of PickIndex.
struct FaceHit {
  double distance = std::numeric_limits<double>::infinity();
  int triangle = -1;  ///< -1 with a finite distance: the section of a solid
  double u = 0, v = 0;
};

/// An edge or vertex near the ray.
struct NearHit {
  int item = -1;
  double distance = 0;  ///< along the ray
  double off = 0;       ///< distance from the ray divided by the tolerance, 0..1
  Vec3 point = Vec3::Zero();
};

struct PickIndex::Tree {
  explicit Tree(const SceneData&);

  [[nodiscard]] FaceHit firstFace(const Ray&, const std::optional<CutPlane>&) const;
  /// Edge segments, or vertices, within the tolerance and not farther than `limit`, the best first.
  [[nodiscard]] std::vector<NearHit> segmentsNear(const Ray&, const PickOptions&, double limit) const;
  [[nodiscard]] std::vector<NearHit> verticesNear(const Ray&, const PickOptions&, double limit) const;
  [[nodiscard]] bool hidden(const NearHit&, const Ray&, const PickOptions&) const;
  [[nodiscard]] Vec3 normalAt(const FaceHit&) const;
  [[nodiscard]] const Vec3& corner(int triangle, std::size_t k) const {
    return points[static_cast<std::size_t>(triangles[static_cast<std::size_t>(triangle)][k])];
  }

  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  vtkSmartPointer<vtkPolyData> faces;  // for its normals
  std::vector<int> faceNumbers;        // per triangle; empty: no numbers
  std::vector<Vec3> linePoints;
  std::vector<int> segments;     // each from linePoints[s] to the next
  std::vector<int> edgeNumbers;  // per segment
  std::vector<Vec3> vertices;
  bool solid = false;
  double size = 0;  // diagonal
  RayTree triangleTree, segmentTree, vertexTree;
};

}  // namespace blossom
