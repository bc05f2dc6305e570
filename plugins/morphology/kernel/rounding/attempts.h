#pragma once
#include <optional>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_crossing.h"

namespace blossom::morphology {

/// Looks at ways to write one surface down until one crosses nowhere. Meshes come about a centre and go where it lies.
class Attempts {
 public:
  Attempts(const Vec3& centre, const Progress& progress) : centre_(centre), progress_(progress) {}

  /// Nothing where it crosses itself or is not closed.
  [[nodiscard]] std::optional<Mesh> asIs(const Mesh&);
  /// Polygons that cross something are split: their triangles may run otherwise than those their readers make.
  [[nodiscard]] std::optional<Mesh> withFewerPolygons(Mesh);
  /// Of the last closed one.
  [[nodiscard]] const std::optional<MeshCrossing>& crossing() const { return crossing_; }

 private:
  const Vec3& centre_;
  const Progress& progress_;
  std::optional<MeshCrossing> crossing_;
};

}  // namespace blossom::morphology
