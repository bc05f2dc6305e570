#pragma once
#include <filesystem>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom::svg {

/// Writes curves or a region as SVG paths in mm. Lines, arcs and Béziers up to degree 3 are written exactly, other splines
/// as cubics within the option `tolerance`. A sequence becomes an animation (SMIL) of `seconds`; viewers without animation
/// show the first frame. @throws Error FileUnwritable, OutputNotSupported, Cancelled.
void writeDocument(const Shape&, const std::filesystem::path&, const Value& options, const Progress&);

}  // namespace blossom::svg
