#pragma once
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/bounds.h"
#include "support/modeling.h"

/// Solids of upright blocks, and their faces.
namespace blossom::test {

struct Block {
  Vec3 low, high;
};

inline Shape solidOf(const Block& b) {
  const Vec3 size = b.high - b.low;
  return made("box", {{"width", size.x()},
                      {"depth", size.y()},
                      {"height", size.z()},
                      {"position", {b.low.x(), b.low.y(), b.low.z()}}})
      .shape;
}

inline Shape with(const Shape& solid, const Block& more) {
  return made("boolean", {{"operation", "union"}}, {solid, solidOf(more)}).shape;
}
inline Shape without(const Shape& solid, const Block& less) {
  return made("boolean", {{"operation", "difference"}}, {solid, solidOf(less)}).shape;
}

/// The number of the face whose box is this one.
inline int faceWithin(const Shape& solid, const Vec3& low, const Vec3& high) {
  const Brep& brep = *solid.get<Brep>();
  for (int i = 0;; ++i) {
    const Bounds box = bounds(Shape(Brep(faceOf(brep, i))));
    if ((box.low - low).norm() < 1e-3 && (box.high - high).norm() < 1e-3) return i;
  }
}

/// As a parameter of a feature that mills it.
inline Value pocketOnFace(int index) { return {{"input", "part"}, {"kind", "face"}, {"index", index}}; }

}  // namespace blossom::test
