#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <optional>
#include <string>
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
/// From corners by number. @throws Error InvalidInput naming the subject.
SurfaceMesh surfaceFrom(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& faces,
                        const std::string& subject);
/// As Nef polyhedron: shells looking inwards are cut out.
Nef nefOf(const SolidBody&);
/// Of one shell that looks outwards and touches itself nowhere.
Nef nefOf(const SurfaceMesh& shell);
/// What a shell turned outwards encloses, and whether that is of the solid or a void in it.
struct NefShell {
  Nef nef;
  Exact::FT volume;
  bool inside = true;
};
/// Solids united, voids cut out, the larger ones first.
Nef nefOf(std::vector<NefShell>);
/// Regularised. Here alone Nef polyhedra are combined: the compiler takes a minute over it.
Nef unionOf(const Nef&, const Nef&);
Nef differenceOf(const Nef&, const Nef&);
Nef symmetricDifferenceOf(const Nef&, const Nef&);
/// Triangulates the facets of a Nef polyhedron.
struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;
};
Triangles trianglesOf(const Nef&);
SurfaceMesh hullOf(const std::vector<Point>&);
SurfaceMesh hullOf(const std::vector<Vec3>&);
/// Neighbouring convex parts joined where their union is nearly convex: the decomposition puts up more
/// walls than it needs. Parts only grow by it, see joinedPartsFlatness.
Parts joinedParts(const Parts&, const Progress&);
bool haveVolume(const std::vector<Point>&);

}  // namespace blossom::morphology
