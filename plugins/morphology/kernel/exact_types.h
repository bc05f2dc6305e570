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
  SurfaceMesh surface;     ///< triangles; without faces when the solid is stored only in `nef`
  std::optional<Nef> nef;  ///< when the surface touches itself
  bool convex = false;
  std::vector<Vec3> gridPoints;  ///< vertices of a convex solid, if their coordinates are doubles whose sums are exact
};

/// Hull of `points`; `grid` are the same points, if they are doubles whose sums are exact.
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
/// A surface from points and indices. @throws Error InvalidInput naming the subject.
SurfaceMesh surfaceFrom(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& faces,
                        const std::string& subject);
/// A Nef polyhedron; shells oriented inward are subtracted.
Nef nefOf(const SolidBody&);
/// A Nef polyhedron of one outward shell that does not touch itself.
Nef nefOf(const SurfaceMesh& shell);
/// The polyhedron enclosed by a shell (oriented outward), and whether it is part of the solid or a void.
struct NefShell {
  Nef nef;
  Exact::FT volume;
  bool inside = true;
};
/// Unites solids and subtracts voids, larger ones first.
Nef nefOf(std::vector<NefShell>);
/// Regularised Boolean operations. Nef polyhedra are combined only here, because the compiler takes a minute for it.
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
/// Joins neighbouring convex parts where their union is nearly convex, because the decomposition makes more walls than
/// needed. Parts only grow by it, see joinedPartsFlatness.
Parts joinedParts(const Parts&, const Progress&);
bool haveVolume(const std::vector<Point>&);

}  // namespace blossom::morphology
