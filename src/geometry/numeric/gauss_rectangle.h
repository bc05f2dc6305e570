#pragma once
#include <Eigen/Core>
#include <array>

#include "geometry/numeric/gauss.h"

namespace blossom {

/// Two integrals computed together, such as area and volume.
using TwoIntegrals = Eigen::Array2d;

struct Rectangle {
  double u0, u1, v0, v1;
};

template <class F>
TwoIntegrals gaussSum(const F& f, const Rectangle& r, std::size_t n) {
  const GaussRule rule = gaussRule(n);
  TwoIntegrals sum(0, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      sum += rule.weights[i] * rule.weights[j] *
             TwoIntegrals(f(r.u0 + (r.u1 - r.u0) * rule.nodes[i], r.v0 + (r.v1 - r.v0) * rule.nodes[j]));
  return sum * ((r.u1 - r.u0) * (r.v1 - r.v0));
}

/// Adaptive tensor-product Gauss quadrature: a rectangle is quartered until the rules with 10 and 14 nodes per side agree
/// within `absolute`. Along a kink the division stops after `depth` levels, where the remaining share is about 4^-depth.
template <class F>
TwoIntegrals integrate(const F& f, const Rectangle& r, const TwoIntegrals& absolute, int depth = 7) {
  const TwoIntegrals coarse = gaussSum(f, r, 10);
  TwoIntegrals fine = gaussSum(f, r, 14);
  // Values that are not finite end the quartering, because quarters of them would differ forever.
  if (depth == 0 || !((fine - coarse).abs() > absolute).any() || !fine.allFinite()) return fine;
  const double u = (r.u0 + r.u1) / 2;
  const double v = (r.v0 + r.v1) / 2;
  TwoIntegrals sum(0, 0);
  for (const Rectangle& part :
       {Rectangle{r.u0, u, r.v0, v}, Rectangle{u, r.u1, r.v0, v}, Rectangle{r.u0, u, v, r.v1}, Rectangle{u, r.u1, v, r.v1}})
    sum += integrate(f, part, absolute, depth - 1);
  return sum;
}

}  // namespace blossom
