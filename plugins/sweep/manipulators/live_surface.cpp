#include "manipulators/live_surface.h"

#include "kernel/edit/apply_edits.h"

namespace blossom::sweep {

namespace {

/// Finer cells cost more at each movement of the mouse than the eye can see; Newton's method finds the rest.
constexpr std::size_t liveSamples = 128;

LiveGrid liveGrid(const Motion& motion) {
  return {motion, evenParameters(motion.domainU(), liveSamples), evenParameters(motion.domainV(), liveSamples)};
}

}  // namespace

LiveSurface::LiveSurface(Shape given, const Motion& applied)
    : shape(std::move(given)), grid(liveGrid(applied)), finder(grid) {}

std::shared_ptr<const LiveSurface> liveSurface(const Shape& shape, const Progress& progress) {
  const Motion& motion = *shape.get<Motion>();
  validate(motion);
  const Motion applied = withEditsApplied(motion, progress);
  progress.check();
  return std::make_shared<const LiveSurface>(shape, applied);
}

}  // namespace blossom::sweep
