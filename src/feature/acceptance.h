#pragma once
#include "feature/feature_type.h"

namespace blossom {

/// Whether an input takes a shape: one of its kinds or, where it takes regions, curves or faces that may bound one
/// (arrangedInputs makes them regions, or says where they do not close). A solid is never a region. O(1).
bool accepts(const InputSpec&, const Shape&);

/// Faces, edges and vertices are named by the input they belong to ("shape:edge:3"); one without a name is of the only
/// input.
/// @param parameters complete and checked  @throws Error InvalidParameter when an input of that name is not declared.
void checkNamedInputs(const FeatureType&, const Value& parameters);

}  // namespace blossom
