#pragma once
#include <vector>

#include "geometry/bspline/curve.h"
#include "geometry/planar/medial_axis.h"
#include "parameter/parameter.h"

namespace blossom {

/// Option `heights`: a medial axis in space, its clearance as height.
ParameterSpec heightsOption(bool fallback);

/// The edges of a medial axis as polylines in space, of degree 1, the clearance as height; those without extent are left
/// out.
std::vector<Curve> spaceCurvesOf(const MedialAxis&);

}  // namespace blossom
