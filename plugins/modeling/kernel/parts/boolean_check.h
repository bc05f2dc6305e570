#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/booleans/region_boolean.h"

namespace blossom::modeling {

/// How far a result is from what a Boolean operation says, as seen from places beside faces of both.
struct BooleanDoubt {
  double share = 0;  ///< of the places that were asked
  Vec3 place = Vec3::Zero();
};

/// Asks of up to 3,000 places, beside the faces of inputs and result by area and by number, whether they lie in the result
/// as they do in the inputs. OCCT's operations can drop an input, or take all of it, where a face touches the seam of a
/// closed surface, and every check of the result itself passes then; the sum of the volumes is right, too. Or its shells
/// cross, and hold space once too often or less than never. Places are judged by triangles alone, those nearer to a surface
/// than these may lie are left out. Nothing when all agree. O(n log n) for n triangles.
/// @param result null: nothing is left  @throws Error Cancelled.
std::optional<BooleanDoubt> booleanDoubt(const std::vector<TopoDS_Shape>& inputs, BooleanOperation,
                                         const TopoDS_Shape& result, const Progress&);

}  // namespace blossom::modeling
