#pragma once
#include "feature/feature_type.h"

namespace blossom::subdivision {

FeatureType subdivideFeature();
FeatureType deformFeature();
FeatureType strokeFeature();

/// Kinds of shapes that can be cages.
inline const std::vector<ShapeKind> cageKinds = {ShapeKind::Mesh, ShapeKind::Curve, ShapeKind::Curves, ShapeKind::Region};

}  // namespace blossom::subdivision
