#pragma once
#include <cmath>
#include <cstddef>
#include <span>

namespace blossom {

/// Gauss-Legendre rule on [0, 1]; exact for polynomials of degree 2 n - 1.
struct GaussRule {
  std::span<const double> nodes;
  std::span<const double> weights;
};

/// Rule with n nodes, 1 <= n <= 32. Nodes are roots of Legendre polynomials found by Newton's method, good to the last bit
/// or two. Hand-written because Boost's rules have their number of nodes as a template parameter.
GaussRule gaussRule(std::size_t n);

namespace detail {

template <class F>
double gaussSum(const F& f, const GaussRule& rule, double from, double to) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * f(from + (to - from) * rule.nodes[i]);
  return sum * (to - from);
}

template <class F>
double integrateHalves(const F& f, const GaussRule& rule, double from, double to, double whole, double absolute, int depth) {
  const double middle = 0.5 * (from + to);
  const double left = gaussSum(f, rule, from, middle);
  const double right = gaussSum(f, rule, middle, to);
  // Halving goes on only for a difference that is there: of what is not finite, all halves are alike.
  if (depth == 0 || !(std::abs(left + right - whole) > absolute) || !std::isfinite(left + right)) return left + right;
  return integrateHalves(f, rule, from, middle, left, absolute, depth - 1) +
         integrateHalves(f, rule, middle, to, right, absolute, depth - 1);
}

}  // namespace detail

struct Adaptivity {
  std::size_t nodes = 16;
  int deepest = 24;  ///< halvings; enough for a cusp, while smooth integrands stop at 1 or 2
};

/// Adaptive integral of a smooth function; each interval is halved until both halves agree with the whole within `absolute`.
template <class F>
double integrate(const F& f, double from, double to, double absolute, const Adaptivity& adaptivity = {}) {
  const GaussRule rule = gaussRule(adaptivity.nodes);
  return detail::integrateHalves(f, rule, from, to, detail::gaussSum(f, rule, from, to), absolute, adaptivity.deepest);
}

}  // namespace blossom
