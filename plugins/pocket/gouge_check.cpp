#include "gouge_check.h"

#include <memory>

#include "toolpath_place.h"

namespace blossom::pocket {

GougeOf gougeOf(Region part, const Vec3& zero, const SimulationOptions& options) {
  const auto shared = std::make_shared<const Region>(std::move(part));
  return [shared, zero, options](const Toolpath& path, const Progress& progress) {
    return gougeOnly(translated(path, -zero), *shared, options, progress);
  };
}

}  // namespace blossom::pocket
