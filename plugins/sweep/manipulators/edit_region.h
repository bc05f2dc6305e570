#pragma once
#include <vector>

#include "geometry/shape/motion.h"
#include "geometry/shape/motion_edit.h"
#include "manipulators/pull_mode.h"

namespace blossom::sweep {

/// Lines on a surface, each part where the surface faces the viewer or turns away from him.
struct SurfaceLines {
  std::vector<std::vector<Vec3>> facing, averted;
};

/// The two iso-curves through a place. @param towards the line of sight, unit length  @param side the sign of n . towards
/// where the surface counts as facing the viewer
SurfaceLines isoCurvesThrough(const Motion&, const MotionPlace&, const Vec3& towards, double side);

/// The part of the domain in which the functions are not 0 by which an edit at one place changes its factors, at the level
/// of the mode. In a motion that is closed in u, u may lie outside the period, and in one that closes in v, v outside its
/// range.
struct EditRegion {
  double firstU = 0, lastU = 0, firstV = 0, lastV = 0;
  bool around = false;  ///< all of u
  bool ring = false;    ///< the motion closes in v, and this is a part of it
};
EditRegion editRegion(const Motion&, const MotionPlace&, const PullMode&);

/// Those of the place and of its copies, as many as differ; of the place alone where its motion allows no copies.
std::vector<EditRegion> editRegions(const Motion&, const MotionPlace&, const PullMode&);

/// Its border; the ends of the surface in v are left out where nothing ends there.
SurfaceLines borderOf(const Motion&, const EditRegion&, const Vec3& towards, double side);

}  // namespace blossom::sweep
