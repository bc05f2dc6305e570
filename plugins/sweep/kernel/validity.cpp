#include "kernel/validity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/grid/motion_point.h"
#include "kernel/grid/span_parameters.h"
#include "kernel/product_surface.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t placesInSpan = 8;

/// Coefficients of W = tw |r|^2 sw as the first component of a surface.
Surface denominator(const Motion& motion, const Progress& progress) {
  const PatchGrid grid = productGrid(motion);
  const auto r = patchPolynomials(motion.orientation, grid);
  PatchPolynomial square = product(r[0], r[0]);
  for (std::size_t c = 1; c < 4; ++c) square.addProduct(r[c], r[c]);
  progress.check();
  const PatchPolynomial weight =
      product(patchPolynomialsInV(motion.trajectory, grid)[3], product(square, patchPolynomials(motion.scaling, grid)[3]));
  progress.check();
  return assemble({weight, weight, weight, weight}, grid);
}

/// Mean of the knots inside the support of a pole.
double greville(int degree, const std::vector<double>& knots, std::size_t pole) {
  const auto from = knots.begin() + static_cast<std::ptrdiff_t>(pole) + 1;
  return std::accumulate(from, from + degree, 0.0) / degree;
}

}  // namespace

Validity examine(const Motion& motion, const Progress& progress) {
  const std::vector<double> us =
      spanParameters(motion.domainU(), {&motion.orientation.knotsU, &motion.scaling.knotsU}, placesInSpan);
  const std::vector<double> vs = spanParameters(
      motion.domainV(), {&motion.orientation.knotsV, &motion.scaling.knotsV, &motion.trajectory.knots}, placesInSpan);
  MotionGrid grid;
  evaluateGrid(motion, us, vs, grid, GridDerivatives::Yes, progress);
  Validity result;
  double largest = 0;
  for (std::size_t k = 0; k < us.size(); ++k)
    for (std::size_t l = 0; l < vs.size(); ++l) {
      const double length = grid.duAt(k, l).cross(grid.dvAt(k, l)).norm();
      largest = std::max(largest, length);
      if ((k == 0 && l == 0) || length < result.smallestNormal)
        result.smallestNormal = length, result.u = us[k], result.v = vs[l], result.place = grid.pointAt(k, l);
    }
  result.smallestShare = largest > 0 ? result.smallestNormal / largest : 0;
  return result;
}

SmallestWeight smallestProductWeight(const Motion& motion, const Progress& progress) {
  const Surface weights = denominator(motion, progress);
  std::size_t smallest = 0;
  double largest = 0;
  for (std::size_t k = 0; k < weights.poles.size(); ++k) {
    if (weights.poles[k][0] < weights.poles[smallest][0]) smallest = k;
    largest = std::max(largest, std::abs(weights.poles[k][0]));
  }
  if (!(largest > 0) || !std::isfinite(largest))
    throw Error(ErrorCode::Degenerate, "The weights of the swept surface vanish or overflow.",
                "Scale the motion's quaternions to about unit length.");
  int exponent = 0;
  std::frexp(largest, &exponent);
  SmallestWeight result;
  result.weight = std::ldexp(weights.poles[smallest][0], -exponent);
  result.u = greville(weights.degreeU, weights.knotsU, smallest / weights.countV());
  result.v = greville(weights.degreeV, weights.knotsV, smallest % weights.countV());
  result.place = evaluate(motion, result.u, result.v).point;
  return result;
}

}  // namespace blossom::sweep
