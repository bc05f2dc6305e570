#include "scene/onion_skin.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace blossom {

std::vector<vtkSmartPointer<vtkProp>> onionSkin(const std::vector<SceneData>& frames, const Look& look, double pixelRatio,
                                                double opacity) {
  std::vector<vtkSmartPointer<vtkProp>> skins;
  const std::size_t count = std::min(maximumSkins, frames.size());
  for (std::size_t k = 0; k < count; ++k) {
    const double t = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0;
    const auto frame = static_cast<std::size_t>(t * static_cast<double>(frames.size() - 1) + 0.5);
    SceneData outline;
    outline.edges = frames[frame].edges;
    outline.planar = frames[frame].planar;
    for (const auto& actor : makeActors(outline, look)) {
      const Color color = mixed(look.control, look.made, t);
      actor->GetMapper()->SetScalarVisibility(false);
      actor->GetProperty()->SetColor(color.red, color.green, color.blue);
      actor->GetProperty()->SetOpacity(opacity);
      actor->GetProperty()->SetLineWidth(static_cast<float>(look.edgeWidth * pixelRatio));
      actor->SetPickable(false);
      skins.emplace_back(actor);
    }
  }
  return skins;
}

}  // namespace blossom
