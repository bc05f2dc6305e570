#pragma once
#include <vector>

#include "ui/plugin/manipulator.h"

namespace blossom::minkowski {

/// The names of the ways that a comparison shows, each where its outlines begin.
std::vector<vtkSmartPointer<vtkProp>> comparisonLabels(const ui::OverlayContext&);

}  // namespace blossom::minkowski
