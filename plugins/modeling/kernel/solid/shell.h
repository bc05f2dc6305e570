#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

enum class ShellSide { Inside, Outside };

struct ShellOptions {
  double thickness = 2;
  ShellSide side = ShellSide::Inside;  ///< of the given faces where the wall grows
  std::vector<int> openFaces;          ///< numbers of faces that are left away; none: a closed hollow
};

struct ShellResult {
  TopoDS_Shape shape;
};

/// Turns a solid into walls of even thickness. Outside, corners stay sharp.
/// @throws Error NotFound, InvalidInput (with the thickest wall that works), Degenerate, Cancelled.
ShellResult shell(const TopoDS_Shape&, const ShellOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
