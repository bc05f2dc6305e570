#pragma once
#include <filesystem>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom::svg {

/// Curves or a region as SVG paths in mm: lines, arcs and Béziers up to degree 3 stay what they are, other splines become
/// cubics within the option `tolerance`. A sequence of these is an animation (SMIL) of the option `seconds`, of which a
/// program that plays none shows the first frame. @throws Error FileUnwritable, OutputNotSupported, Cancelled.
void writeDocument(const Shape&, const std::filesystem::path&, const Value& options, const Progress&);

}  // namespace blossom::svg
