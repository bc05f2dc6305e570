#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/bspline/surface.h"

/// Surfaces evaluated on a grid of parameters; the basis functions are tabulated once per row and once per column.
namespace blossom {

/// Samples at a knot where the surface may have a kink.
enum class Kinks {
  Twice,  ///< two samples, one with the normal of each side
  Once
};

/// A parameter at which a surface is evaluated.
struct GridSample {
  double t = 0;
  std::size_t span = 0;      ///< knot span whose polynomial is evaluated
  std::size_t interval = 0;  ///< index of the interval between breaks
  bool between = false;      ///< an extra sample between two steps, when `times` is more than 1
};

struct SurfaceGrid {
  std::vector<GridSample> u, v;
  std::vector<Vec3> points;   ///< u.size() * v.size(), u-major
  std::vector<Vec3> normals;  ///< unit length, along du x dv; at poles the limit from inside; empty with GridNormals::No

  [[nodiscard]] const Vec3& point(std::size_t i, std::size_t j) const { return points[i * v.size() + j]; }
  /// False when sample i and the next are the two samples of a kink.
  [[nodiscard]] bool connectedU(std::size_t i) const { return u[i].t != u[i + 1].t; }
  [[nodiscard]] bool connectedV(std::size_t j) const { return v[j].t != v[j + 1].t; }
};

/// The distinct knots within the domain.
std::vector<double> domainBreaks(int degree, const std::vector<double>& knots);

/// Samples with `steps[k] * times` steps in interval k of `breaks`.
std::vector<GridSample> samples(int degree, const std::vector<double>& knots, const std::vector<double>& breaks,
                                const std::vector<int>& steps, int times, Kinks kinks = Kinks::Twice);
/// Samples at the given parameters, which lie within the domain.
std::vector<GridSample> samplesAt(int degree, const std::vector<double>& knots, const std::vector<double>& parameters);

enum class GridNormals { Yes, No };

/// O(p q) per row and O(q) per point, in parallel. @throws Error Degenerate when the surface runs through infinity,
/// Cancelled.
SurfaceGrid evaluateGrid(const Surface&, std::vector<GridSample> u, std::vector<GridSample> v, const Progress&,
                         GridNormals = GridNormals::Yes);

/// Curvature of a surface at a point: normal components of the second derivatives and lengths of the first derivatives.
struct SecondOrder {
  double bendUU = 0, bendUV = 0, bendVV = 0;
  double speedU = 0, speedV = 0;
};
SecondOrder secondOrder(const Surface&, double u, double v);

}  // namespace blossom
