#pragma once
#include <vtkSmartPointer.h>

#include <vector>

#include "scene/scene.h"

class vtkProp;

namespace blossom {

inline constexpr std::size_t maximumSkins = 12;

/// The outlines of up to `maximumSkins` frames of a sequence at equal intervals, including first and last; later frames in
/// warmer colours.
std::vector<vtkSmartPointer<vtkProp>> onionSkin(const std::vector<SceneData>& frames, const Look&, double pixelRatio,
                                                double opacity = 0.45);

}  // namespace blossom
