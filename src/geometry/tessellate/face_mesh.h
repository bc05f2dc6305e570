#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "core/vector.h"

namespace blossom {

/// A face with OCCT's triangles of it.
struct FaceMesh {
  TopoDS_Face face;
  TopLoc_Location location;
  Handle(Poly_Triangulation) triangulation;
  const std::vector<Vec3>* normals = nullptr;  ///< of a structured grid, whose chord is kept already
  int offset = 0;                              ///< of its points in the result
};

/// Parameters in the middle of a face, towards which a degenerate normal is sought.
gp_Pnt2d parameterCenter(const Poly_Triangulation&);

/// The unit normal of a surface; at a pole, that of a point a little way inside.
Vec3 normalAt(const BRepAdaptor_Surface&, const gp_Pnt2d& uv, const gp_Pnt2d& center);

/// The parameter that means nothing at a node: where a surface shrinks to a point, as in the tip of a cone, all values of
/// the one that runs round it are the same place.
enum class Collapsed { No, U, V };

/// One for each node.
std::vector<Collapsed> collapsedParameters(const Poly_Triangulation&, const BRepAdaptor_Surface&);

/// Distance from a triangle's plane to the surface point in the middle of its parameters.
double sag(const FaceMesh&, const BRepAdaptor_Surface&, const Poly_Triangle&, const std::vector<Collapsed>&);

}  // namespace blossom
