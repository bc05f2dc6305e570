#pragma once
#include <optional>
#include <span>

#include "geometry/planar/region.h"

namespace blossom {

/// C2 cubic spline through points with chord-length parameters (de Boor, A Practical Guide to Splines, ch. IV), with the
/// given end tangents, else natural ends; periodic when closed. Coincident neighbours count once. O(n). Empty when fewer
/// than two points differ.
std::optional<Spline2> interpolated(std::span<const Vec2> points, bool closed, const std::optional<Vec2>& startTangent = {},
                                    const std::optional<Vec2>& endTangent = {});

}  // namespace blossom
