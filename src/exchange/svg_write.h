#pragma once
#include <filesystem>

#include "core/progress.h"
#include "geometry/shape.h"
#include "parameter/value.h"

namespace blossom::svg {

/// Curves or a region as SVG paths in mm: lines, arcs and Béziers up to degree 3 stay what they are, other splines become
/// cubics within the option `tolerance`. @throws Error FileUnwritable, Cancelled.
void writeDocument(const Shape&, const std::filesystem::path&, const Value& options, const Progress&);

}  // namespace blossom::svg
