#pragma once
#include <string>
#include <vector>

#include "core/vector.h"

class vtkActor;
class vtkCamera;
class vtkRenderer;

namespace blossom {

/// Direction of a camera, as a turntable about z: yaw 0 looks along +y ("front"), pitch 90 degrees looks down ("top").
struct Turn {
  double yaw = 0;                       ///< degrees
  double pitch = 0;                     ///< degrees, -90..90
  [[nodiscard]] Vec3 toCamera() const;  ///< unit vector from the target to the camera
  [[nodiscard]] Vec3 up() const;        ///< unit vector; also defined at pitch +-90
  [[nodiscard]] Vec3 right() const;
};

/// The turn that looks at a plane along its normal, from the side that the normal points to.
Turn turnTowards(const Vec3& normal);
/// The turn of a named view. @throws Error InvalidParameter.
Turn turnOf(const std::string& view);

/// Target, distance and parallel scale with which a camera sees all points, with a margin on each side.
struct Framing {
  Vec3 target = Vec3::Zero();
  double distance = 1;
  double parallelScale = 1;  ///< half the height of the view in mm, for a parallel projection
};
/// @param aspect width / height  @param viewAngle vertical, degrees  @param margin fraction of the frame. O(points).
Framing frameAll(const std::vector<Vec3>& points, const Turn&, double aspect, double viewAngle, double margin = 0.08);

/// Points that represent everything visible in a renderer (at most about 50,000 of each actor).
std::vector<Vec3> visiblePoints(vtkRenderer*);
/// Adds the points of one actor, whether it is in a renderer or not.
void addPointsOf(vtkActor&, std::vector<Vec3>&);

void place(vtkCamera*, const Turn&, const Framing&);

}  // namespace blossom
