#pragma once
#include <functional>
#include <string>

#include "document/document.h"
#include "feature/feature_type.h"

namespace blossom {
class FormatRegistry;
}

namespace blossom::ui {

/// Canonical parameters of a feature; the default where the document holds none, or one that is wrong.
Value shownParameters(const FeatureType&, const Feature&);

/// Whether a parameter has an effect beside the values of the others and the inputs, so that its row says something.
/// @param isGiven of an input by its name
bool saysAnything(const ParameterSpec&, const FeatureType&, const Feature&, const FormatRegistry&,
                  const std::function<bool(const std::string& input)>& isGiven);

}  // namespace blossom::ui
