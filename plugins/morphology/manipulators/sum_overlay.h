#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::morphology {

/// How a sum is made, when its parameter `facets` asks for it: facets in the colours of their families with a name for each,
/// the reflex corners of both shapes, and with "outlines" the dashed outlines of all facets, also of those inside.
std::vector<vtkSmartPointer<vtkProp>> sumOverlay(const ui::OverlayContext&);

}  // namespace blossom::morphology
