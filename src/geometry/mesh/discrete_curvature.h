#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/values/surface_curvature.h"

namespace blossom {

/// Curvatures at the vertices of triangles: the mean from the cotangent form of the Laplacian, the Gaussian from the angle
/// that is missing to a full turn, each over the mixed Voronoi area of the vertex (Meyer, Desbrun, Schröder & Barr, Discrete
/// Differential-Geometry Operators for Triangulated 2-Manifolds, 2003, equations 4, 9 and 10). The sum of Gaussian curvature
/// times area over a closed surface is 2 pi times its Euler characteristic up to rounding. Where there is no full turn, on
/// the border and at vertices that no triangle uses, the mean of the neighbours within the surface counts, and 0 where there
/// is none.
/// @param normals unit length, one for each point: the side from which the sign of the mean is seen. O(n log n).
/// @throws Error Cancelled.
std::vector<SurfaceCurvature> discreteCurvature(std::span<const Vec3> points, std::span<const Vec3> normals,
                                                std::span<const std::array<int, 3>> triangles,
                                                const Progress& = Progress::none());

/// The mixed Voronoi areas of all vertices, mm^2; together they are the area of the triangles.
std::vector<double> mixedAreas(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles);

}  // namespace blossom
