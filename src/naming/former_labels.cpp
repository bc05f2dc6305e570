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
    const auto& [whole, pieces] = now(label, described, shape, part.kind);
    if (whole == part.index) return label;
    if (pieceOf.empty() && std::find(pieces.begin(), pieces.end(), part.index) != pieces.end()) pieceOf = label;
  }
  return pieceOf.empty() ? "new " + sourceLabel(part) : pieceOf;
}

const FormerLabels::Now& FormerLabels::now(const std::string& label, const Value& described, const Shape& shape,
                                           SubShapeKind kind) {
  if (const auto known = found_.find(label); known != found_.end()) return known->second;
  Now found{foundSourcePart(described, shape, kind), {}};
  if (!found.whole && pieces_ == Pieces::Yes) found.pieces = piecesOfSourcePart(described, shape, kind);
  return found_.emplace(label, std::move(found)).first->second;
}

bool FormerLabels::someAreGone() const {
  return std::any_of(found_.begin(), found_.end(), [](const auto& each) { return !each.second.whole; });
}

}  // namespace blossom
