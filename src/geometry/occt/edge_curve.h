#pragma once
#include <Geom_BSplineCurve.hxx>
#include <TopoDS_Edge.hxx>

namespace blossom {

/// The curve of an edge over its range, in the direction of the curve. Ranges that pass the ends of their curves, as files
/// have them by a rounding, end there. Null for an edge without a curve in space.
/// @throws Error InvalidInput when range and curve have nothing in common
Handle(Geom_BSplineCurve) edgeSpline(const TopoDS_Edge&);

}  // namespace blossom
