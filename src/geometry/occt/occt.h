#pragma once
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "geometry/bspline/curve.h"
#include "geometry/bspline/surface.h"
#include "geometry/mesh/mesh.h"
#include "geometry/planar/region.h"
#include "geometry/shape/brep.h"

namespace blossom {

/// Conversion to and from OCCT. Knot values and parametrisation are kept; degrees up to 25 (OCCT's limit). Unclamped knot
/// vectors are clamped by knot insertion first.
/// @throws Error InvalidInput (weight <= 0, degree > 25), Degenerate.
Handle(Geom_BSplineCurve) toOcct(const Curve&);
Handle(Geom_BSplineSurface) toOcct(const Surface&);
Curve fromOcct(const Handle(Geom_BSplineCurve) &);
Surface fromOcct(const Handle(Geom_BSplineSurface) &);

/// A face over the whole domain.
TopoDS_Face toFace(const Surface&);
/// Planar faces in z = 0, one per component; a compound when there are several.
TopoDS_Shape toFaces(const Region&);
/// Wires in z = 0, one per path.
TopoDS_Shape toWires(const Curves&);
/// Edges and wires of a shape in a plane z = const as planar curves. Lines, circles and B-splines keep their type.
Curves planarCurves(const TopoDS_Shape&);
/// A sewn shell with a face per planar polygon or triangle; a solid when the mesh is closed.
TopoDS_Shape toShape(const Mesh&);

}  // namespace blossom
