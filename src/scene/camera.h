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
/// The same, where "auto" is "top" for points in a plane z = constant and "iso" for others.
Turn turnOf(const std::string& view, const std::vector<Vec3>& seen);

/// Target, distance and parallel scale with which a camera sees all points, with a margin on each side.
struct Framing {
  Vec3 target = Vec3::Zero();
  double distance = 1;
  double parallelScale = 1;  ///< half the height of the view in mm, for a parallel projection
};
inline constexpr double marginOfFrames = 0.08;
/// @param aspect width / height  @param viewAngle vertical, degrees  @param margin fraction of the frame. O(points).
Framing frameAll(const std::vector<Vec3>& points, const Turn&, double aspect, double viewAngle,
                 double margin = marginOfFrames);

/// Some of the points, at most 32, by which frameAll frames all of them in the same way, also together with points chosen
/// likewise of other shapes, and which have the same box: what a camera needs to know of a shape that is seen in a view of
/// that name ("auto" too). O(points).
std::vector<Vec3> outermostPoints(const std::vector<Vec3>&, const std::string& view, double aspect);

/// Points that represent everything visible in a renderer (at most about 50,000 of each actor).
std::vector<Vec3> visiblePoints(vtkRenderer*);
/// Adds the points of one actor, whether it is in a renderer or not.
void addPointsOf(vtkActor&, std::vector<Vec3>&);

/// Places the camera as fitCamera, but so that the points given are visible, whatever is in the renderer: pictures of one
/// size with the same points have the same camera. @throws Error InvalidParameter.
void fitCameraTo(const std::vector<Vec3>&, vtkRenderer*, const std::string& view);

void place(vtkCamera*, const Turn&, const Framing&);

}  // namespace blossom
