#pragma once
#include "feature/feature_type.h"

namespace blossom {

/// Whether an input takes a shape: one of its kinds or, where it takes regions, curves or faces that may bound one
/// (arrangedInputs makes them regions, or says where they do not close). A solid is never a region. O(1).
bool accepts(const InputSpec&, const Shape&);

}  // namespace blossom
