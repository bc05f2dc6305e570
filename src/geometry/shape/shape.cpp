#include "geometry/shape/shape.h"

#include "geometry/planar/planar.h"

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
    case ShapeKind::MedialAxis:
      return "medial axis";
    case ShapeKind::Toolpath:
      return "toolpath";
    case ShapeKind::Setup:
      return "setup";
  }
  return "nothing";
}

std::optional<Curves> drawingOf(const Shape& shape) {
  if (const auto* region = shape.get<Region>()) return toCurves(*region);
  if (const auto* curves = shape.get<Curves>()) return *curves;
  if (const auto* axis = shape.get<MedialAxis>()) return drawingOf(*axis);
  if (const auto* path = shape.get<Toolpath>()) return drawingOf(*path);
  return std::nullopt;
}

}  // namespace blossom
