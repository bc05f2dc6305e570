#pragma once
#include <string>
#include <vector>

#include "core/vector.h"
#include "geometry/occt/sub_shape.h"
#include "parameter/value.h"

namespace blossom {

/// What tells a face, an edge or a vertex apart when nothing is known of where it came from.
struct Likeness {
  std::string form;     ///< "plane", "cylinder", "line", "circle", ..
  Vec3 place{0, 0, 0};  ///< centre of mass of a face, middle of an edge, the vertex itself
  double size = 0;      ///< area or length in mm

  /// Whether form, place and size agree within a distance in mm.
  [[nodiscard]] bool isLike(const Likeness&, double tolerance) const;
};

/// Those of all sub-shapes of a kind, in the order of their numbers (geometry/occt/sub_shape.h); none for kinds of shapes
/// that are not numbered. O(size).
std::vector<Likeness> likenesses(const Shape&, SubShapeKind);
/// That of one of them. @throws Error NotFound.
Likeness likenessOf(const Shape&, SubShapeKind, int index);
/// A number for the structure of a shape: counts, forms and order of its faces and edges. Shapes that the same construction
/// makes of other sizes have the same one, and their sub-shapes the same numbers.
std::string structureOf(const Shape&);
/// Distance in mm below which places in a shape are the same.
double samePlace(const Shape&);

Value toJson(const Likeness&);
/// @throws nlohmann::json::exception for values of another form.
Likeness likenessFrom(const Value&);

}  // namespace blossom
