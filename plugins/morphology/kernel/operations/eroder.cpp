#include "kernel/operations/eroder.h"

#include <utility>

namespace blossom::morphology {

Bounds minus(const Bounds& a, const Bounds& b) {
  Bounds room;
  const Vec3 low = a.low - b.low, high = a.high - b.high;
  if ((high - low).minCoeff() <= 0) return room;
  room.add(low);
  room.add(high);
  return room;
}

Eroder::Eroder(Work& work, Solid solid, const Bounds& bounds) : work_(work), solid_(std::move(solid)), bounds_(bounds) {}

Solid Eroder::by(const Parts& element, const Bounds& reach, double grid, double from, double to) {
  const Bounds room = minus(bounds_, reach);
  if (room.empty) return nullptr;
  if (isConvex(solid_)) {
    work_.stats().partsA = 1;
    work_.stats().partsB = partCount(element);
    Stopwatch watch;
    Solid made = shrunk(solid_, element, work_.progress().part(from, to));
    work_.stats().sumMs += watch.lapMs();
    return made;
  }
  const double third = (to - from) / 3;
  if (!outside_) outside_ = work_.outside(solid_, bounds_, from, from + third);
  const Solid beyond = work_.sum(outside_, scaled(element, -1, grid), from + third, to);
  Stopwatch watch;
  Solid made = cutFrom(room, beyond, work_.progress());
  work_.stats().uniteMs += watch.lapMs();
  return made;
}

}  // namespace blossom::morphology
