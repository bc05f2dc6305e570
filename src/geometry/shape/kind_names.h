#pragma once
#include <span>
#include <string>

#include "geometry/shape/shape.h"

namespace blossom {

/// "curves", "a mesh": the name in a sentence.
std::string withArticle(ShapeKind);

/// "region, curves or mesh"; with articles: "a region, curves or a mesh".
std::string kindNames(std::span<const ShapeKind>, bool articles = false);

}  // namespace blossom
