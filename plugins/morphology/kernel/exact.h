#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/values/box.h"
#include "kernel/place.h"

/// Solids in exact arithmetic and sums of their convex parts. CGAL stays behind these handles.
namespace blossom::morphology {

struct SolidBody;
struct PartList;

/// A regular closed polyhedron with exact vertices; holes, voids and several components are allowed. Immutable and shared,
/// but evaluated lazily: use each from one thread at a time.
using Solid = std::shared_ptr<const SolidBody>;

/// Convex pieces (each the hull of its points, of any dimension) whose union is the shape.
using Parts = std::shared_ptr<const PartList>;

/// Counts and times of a sum.
struct SumCounts {
  std::size_t pairs = 0;       ///< number of pairs of convex pieces that were added
  std::size_t candidates = 0;  ///< facets of their sums before the union
  double sumMs = 0, uniteMs = 0;
};

/// The solid of closed, oriented, manifold triangles without intersections; shells oriented inward are voids. Coordinates
/// are not rounded. Shells may touch themselves in common vertices and edges.
/// @throws Error InvalidInput that names the subject, Cancelled.
Solid exactSolid(const Mesh& triangles, const Subject&, const Progress&);
Solid box(const Bounds&);
/// nullptr when the points lie in a plane.
Solid hull(const std::vector<Vec3>& points);
/// The same as closed triangles over its corners; without faces when the points lie in a plane.
Mesh hullTriangles(const std::vector<Vec3>& points);
/// @pre the triangles are a hull, with coordinates whose sums are exact in doubles
Solid convexSolid(const Mesh& hull);

[[nodiscard]] bool isEmpty(const Solid&);
[[nodiscard]] bool isConvex(const Solid&);

/// Convex decomposition by CGAL: walls through the reflex edges, O(r^2) parts for r of them.
Parts convexParts(const Solid&, const Progress&);
/// Convex decomposition of frame - solid.
Parts convexPartsOutside(const Solid&, const Bounds& frame, const Progress&);
/// Pieces from their corners: points, segments or triangles.
Parts piecesOf(const std::vector<std::vector<Vec3>>&);
[[nodiscard]] std::size_t partCount(const Parts&);
/// Pieces times `factor`, which may be negative, with coordinates rounded to multiples of `grid` where they were multiples
/// before.
Parts scaled(const Parts&, double factor, double grid);

/// The union of a + b over all pairs of pieces, without parts of zero volume. Adjacent pieces are united first, by CGAL's
/// corefinement, or as Nef polyhedra where the surface would touch itself.
Solid sumOf(const Parts& a, const Parts& b, SumCounts&, const Progress&);
/// factorA a + factorB b by CGAL::minkowski_sum_3 alone: CGAL's convex parts, united as Nef polyhedra. Coplanar faces do not
/// slow it down. Factors above 0.
Solid minkowskiSum(const Solid& a, double factorA, const Solid& b, double factorB, const Progress&);
/// {x : x + b in a for every b of `parts`}, for a convex solid a: its planes are moved inward.
Solid shrunk(const Solid& convex, const Parts& parts, const Progress&);
/// frame - solid.
Solid cutFrom(const Bounds& frame, const Solid&, const Progress&);

/// Closed, oriented triangles with vertices rounded to doubles, translated by `shift`.
Mesh rounded(const Solid&, const Vec3& shift, const Progress&);

}  // namespace blossom::morphology
