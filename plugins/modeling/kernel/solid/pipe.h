#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"

namespace blossom::modeling {

enum class PipeCorners { Mitred, Round };

struct PipeOptions {
  PipeCorners corners = PipeCorners::Mitred;  ///< at corners of the path
  bool place =
      true;  ///< move the profile so that its xy plane is perpendicular to the path at its start, origin on the path
};

struct PipeResult {
  TopoDS_Shape shape;
  bool solid = false;
  std::vector<std::string> warnings;  ///< where a sheet cuts through itself, or the pipe is wider than the radius of a bend
};

/// Sweeps an outline along a path without twist (corrected Frenet frame). Faces make solids with their holes, wires make
/// sheets.
/// @throws Error InvalidInput, Degenerate, Cancelled.
PipeResult pipe(const TopoDS_Shape& profile, const TopoDS_Shape& path, const PipeOptions&,
                const Progress& = Progress::none());

}  // namespace blossom::modeling
