#pragma once
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/shape/motion.h"
#include "support/random.h"

/// Shapes that cross themselves by a known depth, or come as near to it by a known gap, each built from lines and circles so
/// that plane geometry tells which. `by` is in mm: above 0 one part reaches so far beyond the other, below 0 that is left
/// between them.
namespace blossom::test {

inline TopoDS_Wire polyline(const std::vector<Vec3>& corners, bool closed) {
  BRepBuilderAPI_MakePolygon maker;
  for (const Vec3& p : corners) maker.Add(gp_Pnt(p.x(), p.y(), p.z()));
  if (closed) maker.Close();
  return maker.Wire();
}

inline TopoDS_Wire circleWire(const Vec3& center, double radius) {
  const gp_Ax2 axes(gp_Pnt(center.x(), center.y(), center.z()), gp::DZ());
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)).Edge()).Wire();
}

inline TopoDS_Face faceIn(const TopoDS_Wire& wire) { return BRepBuilderAPI_MakeFace(wire).Face(); }

/// A coil of more than one turn about z: the layers a turn apart lie one over the other, and the distance between them goes
/// linearly from `first` at the lower end to `last` at the upper one, whose signs differ when they pass through each other.
/// Rotations by steps of 60 degrees, the radius linear over each, so that a turn later everything is the same but the
/// radius.
inline Motion coil(double radius, double height, double first, double last, int steps) {
  constexpr int stepsOfATurn = 6;
  Motion motion;
  motion.point = Vec3(1, 0, 0);
  motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, height, 1)}};
  std::vector<double> knots{0};
  for (int i = 0; i <= steps; ++i) knots.push_back(i);
  knots.push_back(steps);
  motion.orientation = {1, 1, knots, {0, 0, 1, 1}, {}};
  motion.scaling = motion.orientation;
  for (int i = 0; i <= steps; ++i)
    for (const double gap : {first, last}) {
      const double half = i * std::numbers::pi / stepsOfATurn, r = radius + gap * i / stepsOfATurn;
      motion.orientation.poles.emplace_back(std::cos(half), 0, 0, std::sin(half));
      motion.scaling.poles.emplace_back(r, r, r, 1);
    }
  return motion;
}

/// Poles of a circle about z in two rational cubic arcs over the knots 0, 1/2 and 1; two of those weights are `weight`,
/// however small, and so lie at about `radius` / `weight`. `open` is in mm: how far the end misses the beginning.
inline std::vector<Vec4> circleWithFarPoles(double radius, double weight, double open = 0) {
  // A quadratic arc of half-angle a has the weights 1, cos a and 1, and as a cubic 1, (1 + 2 cos a) / 3 twice, and 1.
  const double half = std::acos((3 * weight - 1) / 2);
  std::vector<Vec4> poles;
  for (const auto& [middle, a] :
       {std::pair(std::numbers::pi, half), std::pair(2 * std::numbers::pi, std::numbers::pi - half)}) {
    const auto at = [&](double angle, double w) { return Vec4(radius * std::cos(angle), radius * std::sin(angle), 0, w); };
    const Vec4 from = at(middle - a, 1), apex = at(middle, std::cos(a)), to = at(middle + a, 1);
    if (poles.empty()) poles.push_back(from);
    poles.insert(poles.end(), {(from + 2 * apex) / 3, (2 * apex + to) / 3, to});
  }
  poles.back() = poles.front() + Vec4(0, 0, open, 0);
  return poles;
}

/// That circle moved along a Bezier curve.
inline Surface circleMoved(const std::vector<Vec4>& circle, const std::vector<Vec3>& way) {
  Surface surface{3, static_cast<int>(way.size()) - 1, {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1}, {}, {}};
  surface.knotsV.assign(way.size(), 0.0);
  surface.knotsV.insert(surface.knotsV.end(), way.size(), 1.0);
  for (const Vec4& pole : circle)
    for (const Vec3& p : way) {
      surface.poles.push_back(pole);
      surface.poles.back().head<3>() += pole[3] * p;
    }
  return surface;
}

/// Two lines of a profile in the xz plane, the second of which ends `by` beyond the first: (a, b), then (c, d) with d on the
/// other side. They are joined by a third side far from both.
inline TopoDS_Wire hookedProfile(double radius, double height, double lean, double by) {
  // The first line goes up and leans; the hook comes back to it at half its height, square to it.
  const Vec3 foot(radius, 0, 0), top(radius + lean, 0, height), middle = (foot + top) / 2;
  const Vec3 along = (top - foot).normalized(), square(along.z(), 0, -along.x());
  const Vec3 away = middle + height * square;
  return polyline({foot, top, Vec3(away + height / 2 * along), away, Vec3(middle - by * square)}, false);
}

/// Circles for a straight loft that turns back: the wall from radius `low` to `high` at `height`, then down to a circle at
/// the half height that is `by` wider than the wall there.
inline std::vector<TopoDS_Wire> cup(double low, double high, double height, double by) {
  return {circleWire({0, 0, 0}, low), circleWire({0, 0, height}, high),
          circleWire({0, 0, height / 2}, (low + high) / 2 + by)};
}

/// A block with a slot whose sides, leaning by `degrees` each over `height`, end `by` beyond each other.
inline TopoDS_Face slotted(double size, double height, double degrees, double by) {
  const double width = 2 * height * std::tan(degrees * std::numbers::pi / 180) - by;
  return faceIn(polyline({{0, 0, 0},
                          {size, 0, 0},
                          {size, size, 0},
                          {(size + width) / 2, size, 0},
                          {(size + width) / 2, size / 3, 0},
                          {(size - width) / 2, size / 3, 0},
                          {(size - width) / 2, size, 0},
                          {0, size, 0}},
                         true));
}

/// A path for a tube of a radius: its last leg passes over the first one, square to it, at twice the radius less `by`.
inline TopoDS_Wire overpass(double size, double radius, double by) {
  const double over = 2 * radius - by;
  return polyline({{0, 0, 0}, {size, 0, 0}, {size, size / 2, 0}, {size / 2, size / 2, over}, {size / 2, -size / 2, over}},
                  false);
}

}  // namespace blossom::test
