#pragma once
#include "document/document.h"
#include "feature/feature_type.h"

namespace blossom::ui {

/// Canonical parameters of a feature; the default where the document holds none, or one that is wrong.
Value shownParameters(const FeatureType&, const Feature&);

}  // namespace blossom::ui
