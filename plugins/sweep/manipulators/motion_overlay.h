#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::sweep {

/// The trajectory, and the axes of the moving frame at a few places along it, the edits of the motion applied.
std::vector<vtkSmartPointer<vtkProp>> motionOverlay(const ui::OverlayContext&);

}  // namespace blossom::sweep
