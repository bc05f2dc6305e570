#pragma once
#include <optional>
#include <vector>

#include "document/document.h"

class QMimeData;

namespace blossom::ui {

/// Features on their way from one document to another: the part of the document that they need, and which of it is meant.
struct ClippedFeatures {
  Document document;
  std::vector<FeatureId> wanted;
};

/// As JSON, the imported files within; written out only when another program asks for it.
QMimeData* toMimeData(ClippedFeatures);
/// nullopt when there are no features in it. @throws Error FormatDamaged, FormatTooNew.
std::optional<ClippedFeatures> fromMimeData(const QMimeData*);
bool holdsFeatures(const QMimeData*);

}  // namespace blossom::ui
