#pragma once
#include "geometry/mesh/mesh.h"

/// What CGAL makes of sums of solids: the oracle of morphology and the peer of its speed. It takes minutes to compile, so
/// that is done once.
namespace blossom::test {

/// weightA a + weightB b by CGAL::minkowski_sum_3 on Nef polyhedra, as closed, oriented triangles; corners are rounded to
/// doubles at the end. @pre closed, oriented triangles that neither meet nor touch themselves; shells that look inwards are
/// voids. Weights above 0.
Mesh sumByNef(const Mesh& a, const Mesh& b, double weightA = 1, double weightB = 1);

}  // namespace blossom::test
