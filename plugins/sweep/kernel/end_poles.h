#pragma once
#include <vector>

#include "geometry/bspline/surface.h"

/// The row of poles at an end in v of a surface that closes in u.
namespace blossom::sweep {

Vec3 euclidean(const Vec4& pole);

/// How far apart points may lie beside a pole that are the same one: `near`, but a pole may lie far beyond the surface and
/// has no finer steps there.
double nearAt(const Vec4& pole, double near);

std::vector<Vec4> endPoles(const Surface&, bool atEnd);

/// The last pole of a closed row is the first one.
Vec3 middleOf(const std::vector<Vec4>& poles);

bool isPoint(const std::vector<Vec4>& poles, const Vec3& middle, double near);

}  // namespace blossom::sweep
