#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/booleans/region_boolean.h"

namespace blossom::modeling {

/// Whether a result is what a Boolean operation says, as seen from places beside faces of inputs and result.
struct BooleanCheck {
  std::optional<Vec3> wrongAt;       ///< a place on the wrong side of the result
  std::vector<std::size_t> unasked;  ///< inputs with no place beside them that could be judged
};

/// Asks of some hundred places beside the faces of each input and of the result, by area and by number (fewer of each where
/// there are many inputs), whether they lie in the result as they do in the inputs. OCCT's operations can drop an input, or
/// take all of it, where a face touches the seam of a closed surface, and every check of the result itself passes then; the
/// sum of the volumes is right, too. Or its shells cross, and hold space once too often or less than never. Places are
/// judged by triangles alone; those nearer to a surface than its triangles may lie are left out, and less than 3 wrong ones,
/// or 0.5 %, of one shape are taken for chance. O(n log n) for n triangles, of which a curved body has no more than its size
/// asks for, however small the others are.
/// @param result null: nothing is left  @param fuzzy mm by which the operation may move faces  @throws Error Cancelled.
BooleanCheck checkBoolean(const std::vector<TopoDS_Shape>& inputs, BooleanOperation, const TopoDS_Shape& result,
                          double fuzzy, const Progress&);

}  // namespace blossom::modeling
