#include "geometry/numeric/gauss.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace blossom {
namespace {

constexpr std::size_t maximumNodes = 32;

struct StoredRule {
  std::vector<double> nodes, weights;
};

struct LegendreValue {
  double value, derivative;
};

LegendreValue legendre(std::size_t n, double x) {
  double previous = 1;
  double current = x;
  for (std::size_t k = 2; k <= n; ++k) {
    const double kk = static_cast<double>(k);
    const double next = ((2 * kk - 1) * x * current - (kk - 1) * previous) / kk;
    previous = current;
    current = next;
  }
  return {current, static_cast<double>(n) * (x * current - previous) / (x * x - 1)};
}

StoredRule makeRule(std::size_t n) {
  StoredRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(n) + 0.5));
    for (int step = 0; step < 8; ++step) {
      const auto [value, derivative] = legendre(n, x);
      x -= value / derivative;
    }
    const double derivative = legendre(n, x).derivative;
    rule.nodes[i] = 0.5 * (1 + x);
    rule.weights[i] = 1 / ((1 - x * x) * derivative * derivative);
  }
  return rule;
}

}  // namespace

GaussRule gaussRule(std::size_t n) {
  static const auto rules = [] {
    std::array<StoredRule, maximumNodes + 1> all;
    for (std::size_t k = 1; k <= maximumNodes; ++k) all[k] = makeRule(k);
    return all;
  }();
  const StoredRule& rule = rules[std::clamp<std::size_t>(n, 1, maximumNodes)];
  return {rule.nodes, rule.weights};
}

}  // namespace blossom
