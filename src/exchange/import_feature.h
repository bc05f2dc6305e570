#pragma once
#include "exchange/format.h"
#include "feature/registry.h"

namespace blossom {

/// The feature type `exchange.import` (command `import`): a shape read from a file. Parameter `file`.
FeatureType importFeature(const FormatRegistry&);

}  // namespace blossom
