#pragma once
#include <TopoDS_Shape.hxx>
#include <string>

namespace blossom::modeling {

/// Message and hint for a construction without a valid solid.
struct Complaint {
  std::string message;
  std::string hint;
};

/// Final check of a construction: its solids, oriented outward, valid (BRepCheck), closed and with a volume; a single solid
/// by itself, several in a compound. Minor defects are repaired by OCCT's shape healing first.
/// @throws Error Degenerate with the complaint when there is no solid or one of them is invalid.
TopoDS_Shape finishedSolid(const TopoDS_Shape&, const Complaint&);

/// Whether finishedSolid would return the shape unchanged.
bool isGoodSolid(const TopoDS_Shape&);

/// The same for faces, shells and wires, which need only be valid.
TopoDS_Shape finishedSheet(const TopoDS_Shape&, const Complaint&);

}  // namespace blossom::modeling
