#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::subdivision {

/// The cage (mesh, polygon or poles) as thin lines and points over the smooth shape that is made of it.
std::vector<vtkSmartPointer<vtkProp>> cageOverlay(const ui::OverlayContext&);

/// Lines that lie in the scene, a little nearer to the eye than faces at the same place.
vtkSmartPointer<vtkProp> sceneLines(const std::vector<std::vector<Vec3>>&, const Color&, double width);

}  // namespace blossom::subdivision
