#pragma once
#include <vtkSmartPointer.h>

#include <vector>

#include "scene/scene.h"

class vtkProp;

namespace blossom::ui {

/// The outlines of up to `most` frames of a sequence, evenly spread, first and last among them; later ones warmer.
std::vector<vtkSmartPointer<vtkProp>> onionSkin(const std::vector<SceneData>& frames, const Look&, double pixelRatio,
                                                std::size_t most = 12);

}  // namespace blossom::ui
