#include "toolpath_place.h"

#include "geometry/shape/bounds.h"

namespace blossom::pocket {

Toolpath translated(Toolpath path, const Vec3& by) {
  path.start += by;
  for (ToolMove& move : path.moves) {
    move.to += by;
    move.center += by.head<2>();
  }
  if (!path.stock.empty) {
    path.stock.low += by;
    path.stock.high += by;
  }
  if (path.task) path.task->zero += by;
  for (ToolMark& mark : path.marks) mark.at += by;
  return path;
}

std::pair<Vec2, Vec2> boxOf(const Region& region) {
  const Bounds box = bounds(region);
  return {box.low.head<2>(), box.high.head<2>()};
}

}  // namespace blossom::pocket
