#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "core/vector.h"
#include "geometry/values/surface_curvature.h"

namespace blossom {

/// A face and its triangulation by OCCT.
struct FaceMesh {
  TopoDS_Face face;
  TopLoc_Location location;
  Handle(Poly_Triangulation) triangulation;
  const std::vector<Vec3>* normals = nullptr;  ///< of a structured grid, which already satisfies the chord
  int offset = 0;                              ///< index of its first point in the result
};

/// Parameters in the middle of a face; a degenerate normal is evaluated a little towards them.
gp_Pnt2d parameterCenter(const Poly_Triangulation&);

/// The unit normal of a surface; at a pole, that of a point a little inside.
Vec3 normalAt(const BRepAdaptor_Surface&, const gp_Pnt2d& uv, const gp_Pnt2d& center);

/// Curvatures with respect to the normal along du x dv, from the second derivatives; at a pole those of a point a little
/// inside, 0 where there are none either.
SurfaceCurvature curvatureAt(const BRepAdaptor_Surface&, const gp_Pnt2d& uv, const gp_Pnt2d& center);

/// The parameter without influence on the position of a node, where an iso-parametric line of the surface shrinks to a
/// point, as at the apex of a cone.
enum class Collapsed { No, U, V };

/// The collapsed parameter of each node.
std::vector<Collapsed> collapsedParameters(const Poly_Triangulation&, const BRepAdaptor_Surface&);

/// Distance of a triangle's plane from the surface point at the mean of its parameters.
double sag(const FaceMesh&, const BRepAdaptor_Surface&, const Poly_Triangle&, const std::vector<Collapsed>&);

}  // namespace blossom
