#pragma once
#include "geometry/tessellate/tessellate.h"

/// The parts of `tessellate` for single kinds of shapes, one file each. `options.chord` is positive here.
namespace blossom {

Tessellation tessellateSurface(const Surface&, const TessellationOptions&, const Progress&);
Tessellation tessellateBrep(const Brep&, const TessellationOptions&, const Progress&);
Tessellation tessellateMesh(const Mesh&, const TessellationOptions&, const Progress&);
Tessellation tessellateRegion(const Region&, const TessellationOptions&, const Progress&);
Tessellation tessellateToolpath(const Toolpath&, double chord, const Progress&);
/// The part, the edges of the stock, the clamps and the cross of the work's zero.
Tessellation tessellateSetup(const Setup&, const TessellationOptions&, const Progress&);

/// Polyline within `chord` of a curve with positive weights, by halving Bézier pieces until their poles are close to the
/// chord.
/// @throws Error Degenerate when the curve runs through infinity.
std::vector<Vec3> polyline(const Curve&, double chord);

}  // namespace blossom
