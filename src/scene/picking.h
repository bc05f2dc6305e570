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

/// The plane `normal . x = offset`; what lies on the side the normal points to is cut away.
struct CutPlane {
  Vec3 normal = Vec3::UnitX();                                                         ///< unit length
  double offset = 0;                                                                   ///< mm
  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p) - offset; }  ///< above 0: cut away
};

/// A part of a shape that was met by a ray. `index` counts as sub-shape parameters do: see geometry/occt/sub_shape.h.
struct SubPick {
  SubShapeKind kind = SubShapeKind::Whole;
  int index = -1;
  Vec3 point = Vec3::Zero();    ///< on the shape
  Vec3 normal = Vec3::UnitZ();  ///< of the face that was met, else towards the eye
  double distance = 0;          ///< along the ray
};

struct PickOptions {
  double tolerance = 0;       ///< mm at distance 0 within which edges and vertices are met
  double tolerancePerMm = 0;  ///< growth of the tolerance along the ray (perspective)
  bool faces = true, edges = true, vertices = true;
  bool facesHide = true;             ///< false: edges and vertices are met through faces, as a wireframe shows them
  std::optional<CutPlane> cut = {};  ///< parts cut away are not met; the cut through a solid is met as Whole
};

/// What is drawn of one part of a shape: the triangles of a face, the polyline of an edge, a point. Empty when there is no
/// part of this number. O(cells of the shape).
SceneData partOf(const SceneData&, SubShapeKind, int index);

/// Finds what a ray meets first in one drawn shape. Built once per shape, O(n log n); a pick costs O(log n). Vertices win
/// over edges and edges over faces when they lie within the tolerance and are not hidden by a nearer face. Edges without a
/// number are met as Whole where nothing else is. Thread-safe once built.
class PickIndex {
 public:
  explicit PickIndex(const SceneData&);
  ~PickIndex();
  [[nodiscard]] std::optional<SubPick> pick(const Ray&, const PickOptions&) const;

  /// Distance to the first face (or cut through a solid) in front of a ray; infinity when there is none.
  [[nodiscard]] double faceDistance(const Ray&, const std::optional<CutPlane>& cut = {}) const;

  /// Numbers, ascending, of the parts of a kind that lie within all of `bounds`: wholly, or with any point when `crossing`.
  /// For Whole: {0} or nothing. What is hidden counts too. O(n).
  [[nodiscard]] std::vector<int> within(const std::vector<CutPlane>& bounds, SubShapeKind, bool crossing) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace blossom
