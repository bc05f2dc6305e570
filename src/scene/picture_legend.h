#pragma once
#include "scene/offscreen.h"
#include "scene/surface_display.h"

namespace blossom {

struct Look;

/// Draws the scale of a curvature into a picture, at the lower left: its colours, the values at its ends and in its middle,
/// and the unit. Of a size that goes with the picture; nothing where the picture is too small for it. O(pixels).
void drawLegend(Image&, SurfaceDisplay, const CurvatureRange&, const Look&);

}  // namespace blossom
