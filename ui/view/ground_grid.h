#pragma once
#include <vtkSmartPointer.h>

#include "core/vector.h"
#include "scene/scene.h"

class vtkActor;
class vtkPolyData;

namespace blossom::ui {

/// The grid on the ground z = 0 with its two axes. Lines are 1, 2 or 5 times a power of ten apart, fade out towards the
/// distance, and follow the camera, so that there is ground wherever one looks.
class GroundGrid {
 public:
  GroundGrid();
  [[nodiscard]] vtkActor* actor() const { return actor_; }
  /// Rebuilds the lines when scale or place ask for it. @returns whether anything changed.
  bool follow(const Vec3& target, double millimetresPerPixel, double viewHeight, const Look&);
  [[nodiscard]] double spacing() const { return spacing_; }  ///< mm between two lines
  [[nodiscard]] double reach() const { return reach_; }      ///< mm from the middle to where it ends

 private:
  void rebuild(const Look&);
  vtkSmartPointer<vtkPolyData> lines_;
  vtkSmartPointer<vtkActor> actor_;
  double spacing_ = 0, reach_ = 0;
  Vec2 center_ = Vec2::Zero();
  Color drawnIn_{-1, -1, -1};
};

}  // namespace blossom::ui
