#pragma once
#include <string>

#include "core/progress.h"
#include "geometry/shape/shape.h"

namespace blossom {

struct MeshChord {
  double chord = 0;  ///< mm
  std::string note;  ///< a sentence when it differs from the chord wanted, else empty
};

/// The chord for a mesh file of a shape when the user has set none: `wanted`, or, when that would make more than half a
/// million triangles, a larger one that makes about so many, but at most 1/2000 of the shape's size. Makes a coarse
/// tessellation when `wanted` is finer than that. @throws Error Cancelled, as tessellate.
MeshChord affordableChord(const Shape&, double wanted, const Progress&);

}  // namespace blossom
