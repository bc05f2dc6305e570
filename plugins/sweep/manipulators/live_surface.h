#pragma once
#include <memory>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "manipulators/place_under_mouse.h"

namespace blossom::sweep {

/// A swept surface as it is before a drag, with all that finding places on it needs.
struct LiveSurface {
  Shape shape;  ///< the motion as it was given
  LiveGrid grid;
  PlaceFinder finder;

  LiveSurface(Shape given, const Motion& applied);
  LiveSurface(const LiveSurface&) = delete;
  LiveSurface& operator=(const LiveSurface&) = delete;
  [[nodiscard]] const Motion& motion() const { return grid.motion(); }  ///< the edits of its file applied
};

/// O(cells log cells), some 10 ms. @pre the shape is a motion. @throws Error as withEditsApplied.
std::shared_ptr<const LiveSurface> liveSurface(const Shape&, const Progress&);

}  // namespace blossom::sweep
