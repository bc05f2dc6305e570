#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "kernel/exact.h"

// Only the files named exact_*.cpp include this: CGAL takes a while to compile.
namespace blossom::morphology {

using Exact = CGAL::Epeck;
using Point = Exact::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Nef = CGAL::Nef_polyhedron_3<Exact>;

struct SolidBody {
  SurfaceMesh surface;     ///< triangles; without faces when only `nef` holds the solid
  std::optional<Nef> nef;  ///< where the surface touches itself
  bool convex = false;
  std::vector<Vec3> gridPoints;  ///< vertices of a convex solid whose coordinates are doubles that sum up exactly
};

/// Hull of `points`; `grid` are the same points where they are doubles that sum up exactly.
struct Part {
  std::vector<Point> points;
  std::vector<Vec3> grid;
};
struct PartList {
  std::vector<Part> parts;
};

inline Point toPoint(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline std::vector<Point> toPoints(const std::vector<Vec3>& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back(toPoint(p));
  return result;
}
/// Rounded to doubles from the exact value.
inline Vec3 toVec3(const Point& p) {
  const auto& e = p.exact();
  return {CGAL::to_double(e.x()), CGAL::to_double(e.y()), CGAL::to_double(e.z())};
}

Solid solidFrom(SurfaceMesh);
Solid solidFrom(Nef);
/// As Nef polyhedron: shells looking inwards are cut out.
Nef nefOf(const SolidBody&);
/// Regularised. Here alone Nef polyhedra are combined: the compiler takes a minute over it.
Nef unionOf(const Nef&, const Nef&);
Nef differenceOf(const Nef&, const Nef&);
/// Triangulates the facets of a Nef polyhedron.
struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;
};
Triangles trianglesOf(const Nef&);
SurfaceMesh hullOf(const std::vector<Point>&);
SurfaceMesh hullOf(const std::vector<Vec3>&);
/// Neighbouring convex parts joined where their union is convex, up to 1e-12 of the size: the decomposition puts up more
/// walls than it needs. Parts only grow by it.
Parts joinedParts(const Parts&, const Progress&);
bool haveVolume(const std::vector<Point>&);

}  // namespace blossom::morphology
