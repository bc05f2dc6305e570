#pragma once
#include <functional>
#include <vector>

#include "geometry/crossing/sheet_mesh.h"
#include "geometry/crossing/smooth_sheets.h"

namespace blossom {

/// Whether a side is to be halved: its ends, and the point of the smooth face at the mean of their parameters.
using SideJudge = std::function<bool(const Vec3& from, const Vec3& to, const Vec3& middle)>;

/// Halves once the sides of triangles that are judged too long, on the smooth face; a side that two triangles share is
/// halved for both. @returns whether there was any. About O(n).
bool divideOnce(std::vector<Vec3>& points, std::vector<SheetTriangle>& triangles, const SmoothSheets&, const SideJudge&);

}  // namespace blossom
