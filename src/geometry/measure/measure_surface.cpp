#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/parallel.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure_parts.h"
#include "geometry/numeric/gauss_rectangle.h"

namespace blossom {
namespace {

std::vector<double> breaks(const std::vector<double>& knots, std::pair<double, double> domain) {
  std::vector<double> result;
  for (const double knot : knots)
    if (knot >= domain.first && knot <= domain.second && (result.empty() || knot > result.back())) result.push_back(knot);
  return result;
}

std::vector<Rectangle> spans(const Surface& surface) {
  const auto u = breaks(surface.knotsU, surface.domainU());
  const auto v = breaks(surface.knotsV, surface.domainV());
  std::vector<Rectangle> result;
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j) result.push_back({u[i], u[i + 1], v[j], v[j + 1]});
  return result;
}

/// What rounding alone makes of an area: where a surface collapses to a curve, |x_u| is a true length and x_v the noise of
/// coordinates. Below it quartering would chase noise down to its last level in every span.
double noiseOfArea(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Vec4& pole : surface.poles) box.extend(Vec3(pole.head<3>() / pole[3]));
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  constexpr double share = 4 * std::numeric_limits<double>::epsilon();
  return share * (surface.degreeU + surface.degreeV) * largest * box.diagonal().norm();
}

}  // namespace

double surfaceArea(const Surface& surface, const Progress& progress) {
  const auto element = [&](double u, double v) {
    progress.check();
    const SurfaceFrame at = frame(surface, u, v);
    return TwoIntegrals(at.du.cross(at.dv).norm(), 0);
  };
  const std::vector<Rectangle> all = spans(surface);
  std::vector<double> areas(all.size());
  const auto everySpan = [&](const Progress& share, const auto& integral) {
    parallelFor(all.size(), 1, share, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) areas[i] = integral(all[i]);
    });
    return std::accumulate(areas.begin(), areas.end(), 0.0);
  };
  const double estimate = everySpan(progress, [&](const Rectangle& span) { return gaussSum(element, span, 4, 4)(0); });
  const TwoIntegrals absolute(1e-11 * estimate + noiseOfArea(surface), 1);
  return everySpan(progress, [&](const Rectangle& span) { return integrate(element, span, absolute)(0); });
}

Measures measureSurface(const Surface& surface, const Progress& progress) {
  const double weight = smallestWeight(surface);
  Measures measures{"surface",
                    {{"degree_u", std::int64_t{surface.degreeU}},
                     {"degree_v", std::int64_t{surface.degreeV}},
                     countMeasure("poles_u", surface.countU()),
                     countMeasure("poles_v", surface.countV()),
                     {"min_weight", weight}}};
  // Without positive weights the surface may run through infinity: it has no area to speak of.
  if (weight > 0) measures.values.push_back({"area", surfaceArea(surface, progress), MeasureUnit::Area});
  return measures;
}

}  // namespace blossom
