#pragma once
#include <optional>

#include "document/document.h"
#include "feature/registry.h"

namespace blossom {

/// ms; what takes longer while something is dragged is previewed, which is not as quick as a frame.
inline constexpr int previewPatience = 120;

/// The document with previews in place of what takes long.
struct QuickPreview {
  Document document;
  FeatureId last;  ///< of the features that are previews in it, the one that comes last
};

/// What is made of a feature, itself included, as previews: where its type has previews (`previewedBy`) and the feature is
/// not one already and makes no sequence. Nothing when there is no such feature. O(features).
std::optional<QuickPreview> quickPreview(const Document&, const Registry&, const FeatureId& changed);

}  // namespace blossom
