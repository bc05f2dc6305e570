#pragma once
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "kernel/operand.h"
#include "kernel/prisms/prism.h"

namespace blossom::morphology {

/// An operand relative to its own centre and rounded to the grid of the operation, so that sums of coordinates are exact in
/// doubles and positions far from the origin lose no digits.
struct Prepared {
  Mesh triangles;  ///< a solid, oriented; bodies that meet are not made one. Without faces for other forms
  std::vector<std::vector<Vec3>> pieces;  ///< other forms: triangles, segments or points
  Mesh hull;                              ///< a convex solid as triangles; of others without faces
  std::vector<Prism> prisms;              ///< the solid as those, where its bodies do not meet
  bool bodiesMeet = false;                ///< bodies of the solid overlap, or touch outside common vertices and edges
  double wallsWithin = 0;                 ///< mm between faces in which they touch but for rounding; 0: they do not
  Bounds bounds;                          ///< relative to `centre`
  Vec3 centre = Vec3::Zero();
  std::string name;
  std::vector<std::string> warnings;
};

/// Common grid of two operands.
struct CommonGrid {
  double step = 1;
  [[nodiscard]] double usualStep() const;  ///< to which they are rounded, unless that makes faces cross
};
CommonGrid gridFor(const Bounds& a, const Bounds& b);

/// @throws Error InvalidInput for a mesh that is no solid, see checkedSolid.
Prepared prepared(const Operand&, const CommonGrid&, const Progress&);

}  // namespace blossom::morphology
