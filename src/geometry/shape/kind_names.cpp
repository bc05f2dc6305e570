#include "geometry/shape/kind_names.h"

namespace blossom {

std::string withArticle(ShapeKind kind) {
  std::string name(shapeKindName(kind));
  if (kind == ShapeKind::None || kind == ShapeKind::Curves) return name;
  return "a " + name;
}

std::string kindNames(std::span<const ShapeKind> kinds, bool articles) {
  std::string text;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0) text += i + 1 == kinds.size() ? " or " : ", ";
    text += articles ? withArticle(kinds[i]) : std::string(shapeKindName(kinds[i]));
  }
  return text;
}

}  // namespace blossom
