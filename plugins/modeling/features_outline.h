#pragma once
#include "core/error.h"
#include "feature/registry.h"

namespace blossom::modeling {

/// A point parameter of an outline. @throws Error InvalidParameter when it is not in the plane z = 0.
Vec2 inPlane(const Vec3&);

FeatureType textFeature();
FeatureType drawnFeature();
/// circle:R, ellipse:A:B, polygon:N:R, star:N:R:r, rectangle:W:H, text:Blossom.
void addOutlineLiterals(Registry&);

}  // namespace blossom::modeling
