#pragma once
#include <optional>
#include <vector>

#include "document/document.h"

class QMimeData;

namespace blossom::ui {

/// Copied features: the part of the document that they depend on, and their ids.
struct ClippedFeatures {
  Document document;
  std::vector<FeatureId> wanted;
};

/// Stores the features as JSON with the imported files; the text is generated only when another program asks for it.
QMimeData* toMimeData(ClippedFeatures);
/// nullopt when it contains no features. @throws Error FormatDamaged, FormatTooNew.
std::optional<ClippedFeatures> fromMimeData(const QMimeData*);
bool holdsFeatures(const QMimeData*);

}  // namespace blossom::ui
