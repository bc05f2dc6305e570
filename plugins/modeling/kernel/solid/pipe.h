#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

enum class PipeCorners { Mitred, Round };

struct PipeOptions {
  PipeCorners corners = PipeCorners::Mitred;  ///< where the path has a corner
  bool place = true;  ///< the origin of the profile's xy plane is put on the start of the path, square to it
};

struct PipeResult {
  TopoDS_Shape shape;
  bool solid = false;
  std::vector<std::string> warnings;  ///< where the pipe is wider than the path's bend
};

/// Moves an outline along a path without twisting it (corrected Frenet frame). Faces give solids (their holes are kept),
/// wires give sheets.
/// @throws Error InvalidInput, Degenerate, Cancelled.
PipeResult pipe(const TopoDS_Shape& profile, const TopoDS_Shape& path, const PipeOptions&,
                const Progress& = Progress::none());

}  // namespace blossom::modeling
