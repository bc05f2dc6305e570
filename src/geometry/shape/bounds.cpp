#include "geometry/shape/bounds.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom {
namespace {

Vec3 lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }

void add(Bounds& box, const Line2& line) {
  box.add(lifted(line.from));
  box.add(lifted(line.to));
}

/// Ends and those of the four outermost points of the circle that the arc passes.
void add(Bounds& box, const Arc2& arc) {
  box.add(lifted(startPoint(Segment(arc))));
  box.add(lifted(endPoint(Segment(arc))));
  const double low = std::min(arc.start, arc.start + arc.sweep);
  const double high = std::max(arc.start, arc.start + arc.sweep);
  constexpr double quarter = std::numbers::pi / 2;
  for (double k = std::ceil(low / quarter); k * quarter <= high; ++k)
    box.add(lifted(arc.center + arc.radius * Vec2(std::cos(k * quarter), std::sin(k * quarter))));
}

void add(Bounds& box, const Spline2& spline) {
  for (const Vec3& pole : spline.poles)
    if (pole.z() > 0) box.add(lifted(euclidean(pole)));
}

Bounds ofPaths(const std::vector<Path>& paths) {
  Bounds box;
  for (const Path& path : paths)
    for (const Segment& segment : path.segments) std::visit([&](const auto& s) { add(box, s); }, segment);
  return box;
}

Bounds ofPoles(const std::vector<Vec4>& poles) {
  Bounds box;
  for (const Vec4& pole : poles)
    if (pole.w() > 0) box.add(pole.head<3>() / pole.w());
  return box;
}

struct BoundsVisitor {
  Bounds operator()(std::monostate) const { return {}; }
  Bounds operator()(const Region& region) const { return ofPaths(region.loops); }
  Bounds operator()(const Curves& curves) const { return ofPaths(curves.paths); }
  Bounds operator()(const Curve& curve) const { return ofPoles(curve.poles); }
  Bounds operator()(const Surface& surface) const { return ofPoles(surface.poles); }
  Bounds operator()(const Motion& motion) const { return ofPoles(motion.trajectory.poles); }
  Bounds operator()(const Mesh& mesh) const {
    Bounds box;
    for (const Vec3& p : mesh.points) box.add(p);
    return box;
  }
  Bounds operator()(const Brep& brep) const {
    Bnd_Box box;
    if (!brep.shape().IsNull()) BRepBndLib::Add(brep.shape(), box, Standard_False);
    if (box.IsVoid()) return {};
    box.SetGap(0);
    const gp_Pnt low = box.CornerMin();
    const gp_Pnt high = box.CornerMax();
    return {{low.X(), low.Y(), low.Z()}, {high.X(), high.Y(), high.Z()}, false};
  }
  Bounds operator()(const MedialAxis& axis) const {
    Bounds box;
    for (const MedialEdge& edge : axis.edges)
      for (const Vec3& p : edge.points) box.add(lifted(p.head<2>()));
    return box;
  }
  Bounds operator()(const Toolpath& path) const {
    Bounds box = path.stock;
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      for (const Vec3& p : polylineOf(startOf(path, i), path.moves[i], 0.1)) box.add(p);
    return box;
  }
  Bounds operator()(const Setup& setup) const {
    Bounds box;
    for (const auto* shapes : {&setup.part, &setup.stock})
      for (const Shape& shape : *shapes) box.add(bounds(shape));
    for (const Bounds& clamp : setup.clamps) box.add(clamp);
    return box;
  }
  Bounds operator()(const Sequence& sequence) const {
    Bounds box;
    for (const Shape& frame : sequence.frames) box.add(bounds(frame));
    return box;
  }
};

}  // namespace

Bounds bounds(const Shape& shape) { return shape.visit(BoundsVisitor{}); }

}  // namespace blossom
