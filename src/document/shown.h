#pragma once
#include <functional>
#include <set>
#include <vector>

#include "document/document.h"
#include "geometry/shape/shape.h"

namespace blossom {

class Registry;

/// The newest shape of a feature; nullptr or empty while there is none.
using ShapeOf = std::function<const Shape*(const FeatureId&)>;

/// How a feature uses another one as its input.
struct InputsByUse {
  std::vector<FeatureId> consumed;  ///< their shapes have gone into the result
  std::vector<FeatureId> controls;  ///< control shapes
};

/// The inputs of a feature that has a result, by what its type declares of them; nothing of one that is suppressed, has no
/// result or is of an unknown type. O(inputs).
InputsByUse inputsByUse(const Feature&, const Registry&, const ShapeOf&);

/// Features whose shapes have gone into the results of others, which are shown in their place. O(n log n).
std::set<FeatureId> usedUp(const Document&, const Registry&, const ShapeOf&);

/// What pictures and files of a document show: its visible features with a shape that are not used up, in document order.
std::vector<FeatureId> shownFeatures(const Document&, const Registry&, const ShapeOf&);

}  // namespace blossom
