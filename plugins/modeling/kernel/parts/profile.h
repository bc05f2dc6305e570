#pragma once
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <vector>

namespace blossom::modeling {

/// What is swept: faces give solids; wires that bound no face give sheets.
struct Profile {
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Wire> wires;
};

/// The faces, wires and edges of a shape; loose edges are joined into wires where they meet.
/// @throws Error InvalidInput when there is nothing to sweep or the shape holds solids.
Profile profileOf(const TopoDS_Shape&);

/// The wires that bound no face, and loose edges joined into wires where they meet; open wires are joined with them.
std::vector<TopoDS_Wire> looseWires(const TopoDS_Shape&);

/// The plane of a face with its normal out of the face, or of a wire (the xy plane's direction for a straight one).
/// @throws Error InvalidInput when it is not flat.
gp_Pln planeOf(const TopoDS_Face&);
gp_Pln planeOf(const TopoDS_Wire&);
/// The one plane that a wire lies in; nothing when it is straight or not flat.
std::optional<gp_Pln> onlyPlaneOf(const TopoDS_Wire&);

}  // namespace blossom::modeling
