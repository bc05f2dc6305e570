#pragma once
#include <cstddef>
#include <optional>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/planar/polygons/effort.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/region.h"

namespace blossom::minkowski {

using namespace planar;

struct LoftOptions {
  double height = 1;                            ///< mm, above 0
  std::optional<double> tolerance{};            ///< mm, between curves and their polygons; empty: see FlatteningOptions
  std::size_t maximumWork = Effort::unlimited;  ///< see effort.h
};

struct LoftResult {
  Mesh mesh;               ///< closed polygons, seen counter-clockwise from outside; A in z = 0, B in z = height
  std::size_t facets = 0;  ///< triangles that edges sweep, before they are resolved
};

/// The solid {((1-t) a + t b, t height) : a in A, b in B, 0 <= t <= 1} between two regions, of any topology: its section at
/// t height is (1-t) A + t B, the morph of the two. Every edge of their convolution sweeps a planar triangle while t runs
/// from 0 to 1, because the pairing of edges and corners does not depend on t (scaling keeps directions), and the solid is
/// where the winding number of the edges at t is positive. Which of the triangles bound is decided by integers alone, on a
/// grid of 2^-46 of the larger extent; corners are rounded to doubles at the end, and those within 1e-10 of the size are
/// one. O(n^2 + m k) for n triangles, of which m pairs cross, with k others near them. Hand-written because CGAL's Nef
/// polyhedra and corefinement take minutes to unite as many bodies, and fail on touching ones.
/// @throws Error InvalidParameter (height), InvalidInput naming the shape and the place (see flattening.h), LimitExceeded,
/// Cancelled; TooMuchWork.
LoftResult loft(const Region& a, const Region& b, const LoftOptions& = {}, const Progress& = Progress::none());
LoftResult loft(const Polygons& a, const Polygons& b, double height, const Progress&, Effort&);

}  // namespace blossom::minkowski
