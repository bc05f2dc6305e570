#include "kernel/parts/placement.h"

#include <fmt/format.h>

#include "core/angle.h"
#include "core/error.h"

namespace blossom::modeling {

gp_Pnt toPoint(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
gp_Dir toDirection(const Vec3& v, const char* what) {
  if (!v.allFinite() || v.norm() < 1e-12)
    throw Error(ErrorCode::InvalidParameter, fmt::format("The {} has no direction: it is zero.", what),
                "Give a vector such as 0,0,1.");
  return {v.x(), v.y(), v.z()};
}

gp_Ax2 frameOf(const Placement& placement) {
  const gp_Dir axis = toDirection(placement.axis, "axis");
  const gp_Dir across = axis.IsParallel(gp::DX(), 1e-9) ? gp::DY() : gp::DX();
  gp_Ax2 frame(toPoint(placement.position), axis, across);
  return frame.Rotated(frame.Axis(), toRadians(placement.turn));
}

}  // namespace blossom::modeling
