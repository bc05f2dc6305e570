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

/// A regular closed polyhedron with exact vertices; holes, voids and several components are allowed. Immutable and shared;
/// its numbers are evaluated lazily, so one thread at a time.
using Solid = std::shared_ptr<const SolidBody>;

/// Convex pieces (each the hull of its points, of any dimension) whose union is a shape.
using Parts = std::shared_ptr<const PartList>;

/// What a sum took.
struct SumCounts {
  std::size_t pairs = 0;       ///< convex pieces added pair by pair
  std::size_t candidates = 0;  ///< facets of those sums before they are united
  double sumMs = 0, uniteMs = 0;
};

/// From closed, oriented, manifold triangles that cross nowhere; shells that look inwards are voids. Coordinates are taken
/// as they are. Shells may touch themselves in common vertices and edges.
/// @throws Error InvalidInput in the words of the subject, Cancelled.
Solid exactSolid(const Mesh& triangles, const Subject&, const Progress&);
Solid box(const Bounds&);
/// nullptr when the points lie in a plane.
Solid hull(const std::vector<Vec3>& points);

[[nodiscard]] bool isEmpty(const Solid&);
[[nodiscard]] bool isConvex(const Solid&);

/// A solid taken apart (CGAL's convex decomposition: walls through the reflex edges, O(r^2) parts for r of them).
Parts convexParts(const Solid&, const Progress&);
/// frame - solid, taken apart.
Parts convexPartsOutside(const Solid&, const Bounds& frame, const Progress&);
/// Each piece is given by its corners: a point, a segment, a triangle.
Parts piecesOf(const std::vector<std::vector<Vec3>>&);
[[nodiscard]] std::size_t partCount(const Parts&);
/// Pieces times `factor` (which may be below 0), moved to coordinates that are multiples of `grid` where they were before.
Parts scaled(const Parts&, double factor, double grid);

/// The union of a + b over all pairs of pieces, without what has no volume. Pieces that lie side by side are united first;
/// CGAL's corefinement does it, Nef polyhedra where the surface would touch itself.
Solid sumOf(const Parts& a, const Parts& b, SumCounts&, const Progress&);
/// factorA a + factorB b by CGAL::minkowski_sum_3 alone: convex parts as CGAL makes them, united as Nef polyhedra. Faces
/// that lie in one plane cost it nothing. Factors above 0.
Solid minkowskiSum(const Solid& a, double factorA, const Solid& b, double factorB, const Progress&);
/// {x : x + b lies in a for every b of `parts`}, for a convex solid: its planes moved inwards.
Solid shrunk(const Solid& convex, const Parts& parts, const Progress&);
/// frame - solid.
Solid cutFrom(const Bounds& frame, const Solid&, const Progress&);

/// Triangles with vertices rounded to doubles, closed and oriented, `shift` added.
Mesh rounded(const Solid&, const Vec3& shift, const Progress&);

}  // namespace blossom::morphology
