#include "moved_shape.h"

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace blossom::pocket {

gp_Trsf movedBy(const Vec3& by) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(by.x(), by.y(), by.z()));
  return move;
}

Shape movedShape(const Shape& shape, const gp_Trsf& by) {
  if (by.Form() == gp_Identity) return shape;
  if (const auto* brep = shape.get<Brep>()) {
    std::vector<BrepInstance> roots = brep->roots();
    for (BrepInstance& root : roots) root.location = by * root.location;
    return Brep(std::move(roots));
  }
  if (const auto* mesh = shape.get<Mesh>()) {
    Mesh moved = *mesh;
    for (Vec3& point : moved.points) {
      const gp_Pnt there = gp_Pnt(point.x(), point.y(), point.z()).Transformed(by);
      point = {there.X(), there.Y(), there.Z()};
    }
    return moved;
  }
  return shape;
}

}  // namespace blossom::pocket
