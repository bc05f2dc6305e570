#pragma once
#include <filesystem>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom {

/// Writes curves or a region as DXF R2000 in mm: LINE, ARC, CIRCLE, LWPOLYLINE with bulges, SPLINE with weights, and curves
/// in space as POLYLINE or SPLINE.
/// @throws Error FileUnwritable, Cancelled.
void writeDxf(const Shape&, const std::filesystem::path&, const Value& options, const Progress&);

}  // namespace blossom
