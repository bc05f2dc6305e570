#pragma once
#include "document/document.h"
#include "feature/feature_type.h"

namespace blossom {
class FormatRegistry;
}

namespace blossom::ui {

/// Canonical parameters of a feature; the default where the document holds none, or one that is wrong.
Value shownParameters(const FeatureType&, const Feature&);

/// Whether a parameter has an effect beside the values of the others, so that its row says something.
bool saysAnything(const ParameterSpec&, const FeatureType&, const Feature&, const FormatRegistry&);

}  // namespace blossom::ui
