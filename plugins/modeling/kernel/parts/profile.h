#pragma once
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <vector>

namespace blossom::modeling {

/// The shape that is swept: faces make solids, wires without a face make sheets.
struct Profile {
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Wire> wires;
};

/// The faces, wires and edges of a shape; loose edges are joined into wires where they meet.
/// @throws Error InvalidInput when there is nothing to sweep or the shape contains solids.
Profile profileOf(const TopoDS_Shape&);

/// The wires that bound no face; loose edges and open wires are joined where they meet.
std::vector<TopoDS_Wire> looseWires(const TopoDS_Shape&);

/// The plane of a face with the normal out of the face, or of a wire (for a straight one a plane parallel to xy).
/// @throws Error InvalidInput when it is not planar.
gp_Pln planeOf(const TopoDS_Face&);
gp_Pln planeOf(const TopoDS_Wire&);
/// The unique plane of a wire; empty when it is straight or not planar.
std::optional<gp_Pln> onlyPlaneOf(const TopoDS_Wire&);

}  // namespace blossom::modeling
