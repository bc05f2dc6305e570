#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

enum class ShellSide { Inside, Outside };

struct ShellOptions {
  double thickness = 2;
  ShellSide side = ShellSide::Inside;  ///< side of the original faces on which the wall lies
  std::vector<int> openFaces;          ///< numbers of faces to remove; none: a closed hollow
};

struct ShellResult {
  TopoDS_Shape shape;
};

/// Hollows a solid to walls of constant thickness. Outside walls keep sharp corners.
/// @throws Error NotFound, InvalidInput (with the maximum thickness that works), Degenerate, Cancelled.
ShellResult shell(const TopoDS_Shape&, const ShellOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
