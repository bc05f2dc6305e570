#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom::modeling {

struct ThinWall {
  Vec3 place = Vec3::Zero();  ///< on the inner or outer skin
  double thickness = 0;       ///< mm from there to the solid
};

/// Where the skin of a hollowed solid comes nearer to the solid's own faces than its walls are thick: there it passes
/// through itself, which OCCT's offsets do without a word where the solid is thinner than two walls. Judged at a grid of
/// places on each face, by triangles of the solid alone. Nothing where no place is nearer by more than a thirtieth; walls
/// that are thinner than a thousandth of the solid are not judged.
/// @param open numbers of the solid's faces that were opened  @throws Error Cancelled.
std::optional<ThinWall> thinWall(const TopoDS_Shape& solid, const std::vector<int>& open, const TopoDS_Shape& made,
                                 double thickness, const Progress&);

}  // namespace blossom::modeling
