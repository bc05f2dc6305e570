#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/bspline/surface.h"

/// Surfaces evaluated on a grid of parameters: basis functions are tabulated once a row and once a column.
namespace blossom {

/// What happens at a knot where a surface may have a kink.
enum class Kinks {
  Twice,  ///< two samples, one for the normal of either side
  Once
};

/// Where a surface is evaluated.
struct GridSample {
  double t = 0;
  std::size_t span = 0;      ///< knot span whose polynomial counts
  std::size_t interval = 0;  ///< index of the interval between breaks
  bool between = false;      ///< two steps, when `times` is more than 1
};

struct SurfaceGrid {
  std::vector<GridSample> u, v;
  std::vector<Vec3> points;   ///< u.size() * v.size(), row by row of u
  std::vector<Vec3> normals;  ///< unit length, along du x dv; at poles the limit from inside; empty when not asked for

  [[nodiscard]] const Vec3& point(std::size_t i, std::size_t j) const { return points[i * v.size() + j]; }
  /// Is there surface between sample i and the next, or are both one kink?
  [[nodiscard]] bool connectedU(std::size_t i) const { return u[i].t != u[i + 1].t; }
  [[nodiscard]] bool connectedV(std::size_t j) const { return v[j].t != v[j + 1].t; }
};

/// The distinct knots within the domain.
std::vector<double> domainBreaks(int degree, const std::vector<double>& knots);

/// `steps[k] * times` steps in the interval k of `breaks`.
std::vector<GridSample> samples(int degree, const std::vector<double>& knots, const std::vector<double>& breaks,
                                const std::vector<int>& steps, int times, Kinks kinks = Kinks::Twice);
/// At any parameters within the domain.
std::vector<GridSample> samplesAt(int degree, const std::vector<double>& knots, const std::vector<double>& parameters);

enum class GridNormals { Yes, No };

/// O(p q) per row and O(q) per point, in parallel. @throws Error Degenerate when the surface runs through infinity,
/// Cancelled.
SurfaceGrid evaluateGrid(const Surface&, std::vector<GridSample> u, std::vector<GridSample> v, const Progress&,
                         GridNormals = GridNormals::Yes);

/// How a surface bends at a point: parts of the second derivatives along the normal, and lengths of the first ones.
struct SecondOrder {
  double bendUU = 0, bendUV = 0, bendVV = 0;
  double speedU = 0, speedV = 0;
};
SecondOrder secondOrder(const Surface&, double u, double v);

}  // namespace blossom
