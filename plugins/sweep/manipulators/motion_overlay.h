#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::sweep {

/// The trajectory, and the axes of the moving frame at a few places along it, the edits of the motion applied.
std::vector<vtkSmartPointer<vtkProp>> motionOverlay(const ui::OverlayContext&);

/// The same with the curves that the point sweeps at the knots: what the motion is going to make, where no surface shows it.
std::vector<vtkSmartPointer<vtkProp>> sweptOverlay(const ui::OverlayContext&);

}  // namespace blossom::sweep
