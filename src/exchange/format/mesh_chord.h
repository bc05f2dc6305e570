#pragma once
#include <string>

#include "core/progress.h"
#include "geometry/shape/shape.h"

namespace blossom {

struct MeshChord {
  double chord = 0;  ///< mm
  std::string note;  ///< a sentence where it is not the chord wanted; else empty
};

/// The chord for a mesh file of a shape when nobody asked for a certain one: `wanted`, or where this would make more than
/// half a million triangles, as much coarser as keeps near that number, but never coarser than 1/2000 of the shape's size.
/// Costs a coarse tessellation where `wanted` is finer than that. @throws Error Cancelled, as tessellate.
MeshChord affordableChord(const Shape&, double wanted, const Progress&);

}  // namespace blossom
