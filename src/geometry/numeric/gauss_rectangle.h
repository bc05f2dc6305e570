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
TwoIntegrals gaussSum(const F& f, const Rectangle& r, std::size_t countU, std::size_t countV) {
  const GaussRule ruleU = gaussRule(countU), ruleV = gaussRule(countV);
  TwoIntegrals sum(0, 0);
  for (std::size_t i = 0; i < countU; ++i)
    for (std::size_t j = 0; j < countV; ++j)
      sum += ruleU.weights[i] * ruleV.weights[j] *
             TwoIntegrals(f(r.u0 + (r.u1 - r.u0) * ruleU.nodes[i], r.v0 + (r.v1 - r.v0) * ruleV.nodes[j]));
  return sum * ((r.u1 - r.u0) * (r.v1 - r.v0));
}

/// How often a rectangle may be divided on: along a kink across both sides, where the share that remains is about
/// 4^-quarters, and along one side alone, where most of an integral may lie in a thin strip.
struct Divisions {
  int quarters = 7, halves = 40;
};

/// Adaptive tensor-product Gauss quadrature: a rectangle is divided until the rules with 10 and 14 nodes per side agree
/// within `absolute`, along one side only where that is the one on which they differ.
template <class F>
TwoIntegrals integrate(const F& f, const Rectangle& r, const TwoIntegrals& absolute, Divisions left = {}) {
  constexpr std::size_t few = 10, many = 14;
  const TwoIntegrals coarse = gaussSum(f, r, few, few);
  TwoIntegrals fine = gaussSum(f, r, many, many);
  const auto differs = [&](const TwoIntegrals& other) { return ((fine - other).abs() > absolute).any(); };
  // Values that are not finite end the division, because parts of them would differ forever.
  if (!differs(coarse) || !fine.allFinite()) return fine;
  const double u = (r.u0 + r.u1) / 2, v = (r.v0 + r.v1) / 2;
  const bool alongU = differs(gaussSum(f, r, few, many)), alongV = differs(gaussSum(f, r, many, few));
  const auto sumOf = [&](const auto& parts, const Divisions& then) {
    TwoIntegrals sum(0, 0);
    for (const Rectangle& part : parts) sum += integrate(f, part, absolute, then);
    return sum;
  };
  if (alongU != alongV && left.halves > 0) {
    const std::array halves = alongU ? std::array{Rectangle{r.u0, u, r.v0, r.v1}, Rectangle{u, r.u1, r.v0, r.v1}}
                                     : std::array{Rectangle{r.u0, r.u1, r.v0, v}, Rectangle{r.u0, r.u1, v, r.v1}};
    return sumOf(halves, {left.quarters, left.halves - 1});
  }
  if (left.quarters == 0) return fine;
  return sumOf(std::array{Rectangle{r.u0, u, r.v0, v}, Rectangle{u, r.u1, r.v0, v}, Rectangle{r.u0, u, v, r.v1},
                          Rectangle{u, r.u1, v, r.v1}},
               {left.quarters - 1, left.halves});
}

}  // namespace blossom
