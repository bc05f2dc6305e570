#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/vector.h"
#include "geometry/occt/sub_shape.h"
#include "scene/scene.h"

namespace blossom {

/// A half line; `direction` has unit length.
struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();
};

/// The plane `normal . x = offset`; the side towards the normal is cut away.
struct CutPlane {
  Vec3 normal = Vec3::UnitX();                                                         ///< unit length
  double offset = 0;                                                                   ///< mm
  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p) - offset; }  ///< above 0: cut away
  [[nodiscard]] Vec3 axis() const;                                                     ///< a direction in the plane
};

/// The sub-shape hit by a ray; `index` as in geometry/occt/sub_shape.h.
struct SubPick {
  SubShapeKind kind = SubShapeKind::Whole;
  int index = -1;
  Vec3 point = Vec3::Zero();    ///< on the shape
  Vec3 normal = Vec3::UnitZ();  ///< of the face; towards the eye for edges and vertices
  double distance = 0;          ///< along the ray
};

struct PickOptions {
  double tolerance = 0;       ///< mm at distance 0, maximum distance of edges and vertices from the ray
  double tolerancePerMm = 0;  ///< growth of the tolerance along the ray (perspective)
  bool faces = true, edges = true, vertices = true;
  bool facesHide = true;             ///< false: edges and vertices behind faces are hit, as in a wireframe
  std::optional<CutPlane> cut = {};  ///< parts cut away are not hit; the section of a solid is hit as Whole
};

/// The drawn data of one sub-shape: the triangles of a face, the polyline of an edge, a point. Empty when there is no
/// sub-shape of this number. O(cells of the shape).
SceneData subShapeData(const SceneData&, SubShapeKind, int index);

/// Finds the first sub-shape of a drawn shape that a ray hits. Built once per shape in O(n log n); a pick costs O(log n).
/// Vertices take precedence over edges and edges over faces when they are within the tolerance and not hidden by a nearer
/// face. Edges without a number are hit as Whole where nothing else is. Thread-safe once built.
class PickIndex {
 public:
  explicit PickIndex(const SceneData&);
  ~PickIndex();
  [[nodiscard]] std::optional<SubPick> pick(const Ray&, const PickOptions&) const;

  /// Distance to the first face or section of a solid along a ray; infinity when there is none.
  [[nodiscard]] double faceDistance(const Ray&, const std::optional<CutPlane>& cut = {}) const;

  /// Numbers, ascending, of the sub-shapes of a kind that lie inside all of `bounds`, or, with `crossing`, have a point
  /// inside. For Whole: {0} or empty. Hidden sub-shapes are included. O(n).
  [[nodiscard]] std::vector<int> within(const std::vector<CutPlane>& bounds, SubShapeKind, bool crossing) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace blossom
