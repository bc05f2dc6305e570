#pragma once
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh.h"
#include "geometry/occt/occt.h"

/// Shapes with closed forms, and their measures by name.
namespace blossom::test {

template <class T>
T measured(const Measures& measures, const std::string& name) {
  for (const Measure& m : measures.values)
    if (m.name == name) return std::get<T>(m.value);
  throw std::runtime_error("no measure " + name);
}
inline bool hasMeasure(const Measures& measures, const std::string& name) {
  for (const Measure& m : measures.values)
    if (m.name == name) return true;
  return false;
}

/// A circle around the origin in the first two coordinates, homogeneous (x, y, w), four rational quadratic arcs.
inline std::vector<Vec3> circlePoles(double x0, double radius) {
  const double h = std::numbers::sqrt2 / 2;
  const std::vector<Vec2> corners{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::vector<Vec3> poles;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double w = i % 2 == 0 ? 1 : h;
    poles.emplace_back(w * (x0 + radius * corners[i].x()), w * radius * corners[i].y(), w);
  }
  return poles;
}
inline const std::vector<double> circleKnots{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};

/// Torus around z as a rational biquadratic surface, normal outwards: u around the axis, v around the tube.
inline Surface torusSurface(double major, double minor) {
  Surface surface{2, 2, circleKnots, circleKnots, {}};
  for (const Vec3& around : circlePoles(0, 1))
    for (const Vec3& tube : circlePoles(major, minor))
      surface.poles.emplace_back(around.x() * tube.x(), around.y() * tube.x(), around.z() * tube.y(), around.z() * tube.z());
  return surface;
}

/// The same torus, of the degrees of an exact sweep.
inline Surface torusOfDegree9x12(double major, double minor) { return elevateDegree(torusSurface(major, minor), 7, 10); }

/// Solid bounded by one face that closes onto itself.
inline TopoDS_Shape solidOf(const TopoDS_Face& face) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, face);
  shell.Closed(Standard_True);
  return BRepBuilderAPI_MakeSolid(shell).Solid();
}

inline Mesh boxMesh(const Vec3& low, const Vec3& size) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(low + Vec3(size.x() * (i & 1), size.y() * ((i >> 1) & 1), size.z() * ((i >> 2) & 1)));
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : faces) mesh.addFace(face);
  return mesh;
}

/// Quads on a torus; closed, of genus 1.
inline Mesh torusMesh(double major, double minor, int around, int tube) {
  Mesh mesh;
  const auto turn = [](int i, int count) { return 2 * std::numbers::pi * i / count; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      const double r = major + minor * std::cos(turn(j, tube));
      mesh.points.emplace_back(r * std::cos(turn(i, around)), r * std::sin(turn(i, around)),
                               minor * std::sin(turn(j, tube)));
    }
  const auto index = [&](int i, int j) { return (i % around) * tube + j % tube; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      const int face[4] = {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)};
      mesh.addFace(face);
    }
  return mesh;
}

}  // namespace blossom::test
