#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::subdivision {

/// The cage (mesh, polygon or poles) as thin lines and points over its smooth shape.
std::vector<vtkSmartPointer<vtkProp>> cageOverlay(const ui::OverlayContext&);

/// Lines in the scene, drawn slightly nearer to the eye than faces at the same place.
vtkSmartPointer<vtkProp> sceneLines(const std::vector<std::vector<Vec3>>&, const Color&, double width);

}  // namespace blossom::subdivision
