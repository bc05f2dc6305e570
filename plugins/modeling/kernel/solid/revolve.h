#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom::modeling {

struct RevolveOptions {
  Vec3 point{0, 0, 0};      ///< on the axis
  Vec3 direction{0, 1, 0};  ///< of the axis
  double angle = 360;       ///< degrees, counter-clockwise seen against the direction; negative: clockwise
};

struct RevolveResult {
  TopoDS_Shape shape;
  bool solid = false;
  std::vector<std::string> warnings;  ///< where a sheet cuts through itself
};

/// Revolves planar faces (to solids) and wires (to sheets) about an axis. The outline may touch the axis but not cross it.
/// Overlapping solids are united.
/// @throws Error InvalidInput, InvalidParameter, Degenerate with the place where a solid would intersect itself.
RevolveResult revolve(const TopoDS_Shape& profile, const RevolveOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
