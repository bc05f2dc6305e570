#pragma once
#include <string>

#include "feature/feature_type.h"

namespace blossom {

/// The manual's page about a feature type in Markdown: inputs, parameters with ranges, units, defaults and help, and how it
/// is called. Made from the declaration alone, so a plugin of anyone's has one too.
std::string referencePage(const FeatureType&);

/// The name of that page beside the others of the manual: "reference/sweep.sweep.md".
std::string referencePageName(const std::string& featureId);

/// "one", "2 or more", "1 to 4".
std::string howMany(const InputSpec&);
/// Whether an input takes sequences frame by frame (feature/acceptance.h).
bool takesByFrames(const FeatureType&);
/// "region or mesh", "any shape".
std::string kindsText(const std::vector<ShapeKind>&);

}  // namespace blossom
