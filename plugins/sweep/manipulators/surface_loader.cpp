#include "manipulators/surface_loader.h"

#include <exception>
#include <utility>

namespace blossom::sweep {

SurfaceLoader::SurfaceLoader(Arrived arrived) : arrived_(std::move(arrived)) {}

SurfaceLoader::~SurfaceLoader() { loading_.cancel(); }

bool SurfaceLoader::load(const Shape& motion) {
  if (motion.get<Motion>() == wanted_.get<Motion>()) return false;
  wanted_ = motion;
  loading_.cancel();
  loading_ = {};
  busy_ = !motion.empty();
  if (busy_) thread_.start([this, motion, token = loading_] { prepare(motion, token); });
  return true;
}

void SurfaceLoader::prepare(const Shape& motion, const CancelToken& token) {
  std::shared_ptr<const LiveSurface> made;
  try {
    made = liveSurface(motion, Progress(token));
  } catch (const std::exception&) {
    // The features made from the motion tell what is wrong with it.
  }
  // A copy of `arrived_`: who is told may end the loader.
  here_.post([this, arrived = arrived_, token, made = std::move(made)] {
    if (token.cancelled()) return;
    busy_ = false;
    if (made) arrived(made);
  });
}

}  // namespace blossom::sweep
