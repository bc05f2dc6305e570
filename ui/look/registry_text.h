#pragma once
#include <QString>
#include <string>

#include "document/document.h"

namespace blossom {
struct FeatureType;
}

namespace blossom::ui {

/// A text of the registry (a title, a summary, a label, a choice, a help) in the language of the window. The registry has
/// them in English, where lupdate does not look; they are translated in resources/translations/features_*.ts, and a test
/// compares these with the registry. A text without a translation stays English.
QString registryText(const std::string& english);

/// A feature as the user adds it: newFeature of document/edits.h, named in the language of the window.
Feature namedFeature(const Document&, const FeatureType&, std::vector<FeatureId> inputs = {});

}  // namespace blossom::ui
