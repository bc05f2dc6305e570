#pragma once
#include <memory>

#include "feature/registry.h"

namespace blossom {

/// The feature type `blossom.literal` (command `literal`): a shape written down, such as "ball:5:3", by the literal forms of
/// the registry that holds it. Parameter `text`. The registry must outlive its evaluations; it is not kept alive.
FeatureType literalFeature(const std::weak_ptr<const Registry>&);

}  // namespace blossom
