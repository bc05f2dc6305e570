#include "manipulators/lingering_picture.h"

#include <algorithm>
#include <limits>

namespace blossom::sweep {

LingeringPicture::LingeringPicture(const ui::ToolHost& host, ui::StandIn picture) : picture_(std::move(picture)) {
  for (const FeatureId& id : picture_.insteadOf) before_.push_back(host.result(id));
}

bool LingeringPicture::isHit(const Ray& ray) const {
  SceneData drawn;
  drawn.faces = picture_.faces;
  return PickIndex(drawn).faceDistance(ray) < std::numeric_limits<double>::infinity();
}

bool LingeringPicture::over(const ui::ToolHost& host) const {
  if (!std::ranges::equal(host.document().features(), document_.features())) return true;
  for (std::size_t k = 0; k < before_.size(); ++k)
    if (host.result(picture_.insteadOf[k]) == before_[k]) return false;
  return true;
}

}  // namespace blossom::sweep
