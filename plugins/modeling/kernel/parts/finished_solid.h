#pragma once
#include <TopoDS_Shape.hxx>
#include <string>

namespace blossom::modeling {

/// What is said when a construction gives no good solid.
struct Complaint {
  std::string message;
  std::string hint;
};

/// What every construction hands out: its solids with all faces looking outward, found valid (BRepCheck), closed and of some
/// volume; one solid by itself, several in a compound. What is slightly wrong is mended by OCCT's shape healing first.
/// @throws Error Degenerate with the complaint when there is no solid or one of them is not good.
TopoDS_Shape finishedSolid(const TopoDS_Shape&, const Complaint&);

/// True when finishedSolid would hand it out as it is.
bool isGoodSolid(const TopoDS_Shape&);

/// The same for faces, shells and wires: only validity counts.
TopoDS_Shape finishedSheet(const TopoDS_Shape&, const Complaint&);

}  // namespace blossom::modeling
