#pragma once
#include "kernel/operations/work.h"

namespace blossom::morphology {

/// Whether the element fits into places of the solid without room to move, as a tool of 4 mm fits a slot of 4 mm. What it
/// leaves there has no volume, so that erosions and openings lose such places: an element that is smaller by a millionth has
/// parts left that it has not, or that reach farther. Takes as long as one erosion, two where it is not known what is left.
/// @param left closed triangles; nothing: not known  @pre bodies of the solid do not meet. @throws Error Cancelled.
bool fitsExactly(Work&, const Prepared& solid, const Prepared& element, const CommonGrid&, const Mesh* left);

}  // namespace blossom::morphology
