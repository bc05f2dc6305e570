#include "geometry/shape.h"

namespace blossom {

std::string_view shapeKindName(ShapeKind kind) noexcept {
  switch (kind) {
    case ShapeKind::None:
      return "nothing";
    case ShapeKind::Region:
      return "region";
    case ShapeKind::Curves:
      return "curves";
    case ShapeKind::Curve:
      return "curve";
    case ShapeKind::Surface:
      return "surface";
    case ShapeKind::Brep:
      return "solid or faces";
    case ShapeKind::Mesh:
      return "mesh";
    case ShapeKind::Motion:
      return "motion";
    case ShapeKind::Sequence:
      return "sequence";
  }
  return "nothing";
}

}  // namespace blossom
