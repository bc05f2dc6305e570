#pragma once
#include "feature/feature_type.h"

namespace blossom {

/// Whether an input accepts a shape: its kind is one of the declared kinds or, for a region input, it is curves or faces
/// that may bound a region (arrangedInputs converts them or reports where they are open). A solid is never accepted as a
/// region. O(1).
bool accepts(const InputSpec&, const Shape&);

/// Checks the inputs named by sub-shape parameters ("shape:edge:3"); a sub-shape without an input name belongs to the only
/// input.
/// @param parameters complete and in canonical form
/// @throws Error InvalidParameter when no input of that name is declared.
void checkNamedInputs(const FeatureType&, const Value& parameters);

}  // namespace blossom
