#pragma once
#include <string>
#include <vector>

#include "geometry/planar/region.h"

namespace blossom::svg {

/// Paths of `d="M.. z"` in its own coordinates: lines, circular arcs, Béziers as splines, elliptic arcs as rational splines.
/// Only paths that end in "z" are closed. @throws Error FormatDamaged.
std::vector<Path> parsePathData(const std::string& data);

/// Elliptic arc between two points (SVG 1.1, appendix F.6); `rotation` in radians. Empty when the ends coincide.
std::vector<Segment> arcSegment(const Vec2& from, const Vec2& to, double rx, double ry, double rotation, bool large,
                                bool sweep);

/// Whole ellipse as one segment; an arc when it is a circle.
Segment ellipseSegment(const Vec2& center, double rx, double ry);

}  // namespace blossom::svg
