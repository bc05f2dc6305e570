#include "naming/former_labels.h"

#include <fmt/format.h>

#include <algorithm>

#include "naming/source_part.h"

namespace blossom {

std::string sourceLabel(const SourcePart& part) {
  return fmt::format("<{}.{} {}>", part.feature, subShapeKindName(part.kind), part.index);
}

std::string FormerLabels::of(const SourcePart& part, const Shape& shape) {
  std::string pieceOf;
  for (const auto& [label, described] : sources_.items()) {
    if (described.at("feature") != part.feature || described.at("kind") != subShapeKindName(part.kind)) continue;
    const auto known = found_.find(label);
    const std::optional<int> now = known != found_.end()
                                       ? known->second
                                       : found_.emplace(label, foundSourcePart(described, shape, part.kind)).first->second;
    if (now == part.index) return label;
    if (now || pieces_ == Pieces::No || !pieceOf.empty()) continue;
    const std::vector<int> pieces = piecesOfSourcePart(described, shape, part.kind);
    if (std::find(pieces.begin(), pieces.end(), part.index) != pieces.end()) pieceOf = label;
  }
  return pieceOf.empty() ? "new " + sourceLabel(part) : pieceOf;
}

bool FormerLabels::someAreGone() const {
  return std::any_of(found_.begin(), found_.end(), [](const auto& each) { return !each.second; });
}

}  // namespace blossom
