#include "kernel/begin/bernstein_zero.h"

#include <algorithm>

namespace blossom::sweep {

namespace {

/// Narrower parts of an interval are points.
constexpr int maximumHalvings = 44;

bool staysAway(const std::vector<Vec3>& coefficients, double minimum) {
  Vec3 direction = Vec3::Zero();
  for (const Vec3& c : coefficients) direction += c;
  const double length = direction.norm();
  if (!(length > 0)) return false;
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [&](const Vec3& c) { return c.dot(direction) >= minimum * length; });
}

std::optional<double> zeroOfPart(std::vector<Vec3> right, double from, double to, double minimum, int halvings) {
  if (staysAway(right, minimum)) return {};
  if (right.front().norm() < minimum) return from;
  if (right.back().norm() < minimum) return to;
  const double middle = from + (to - from) / 2;
  if (halvings == maximumHalvings) return middle;
  // De Casteljau's algorithm at the middle.
  std::vector<Vec3> left{right.front()};
  for (std::size_t level = 1; level < right.size(); ++level) {
    for (std::size_t i = 0; i + level < right.size(); ++i) right[i] = (right[i] + right[i + 1]) / 2;
    left.push_back(right[0]);
  }
  if (const auto zero = zeroOfPart(std::move(left), from, middle, minimum, halvings + 1)) return zero;
  return zeroOfPart(std::move(right), middle, to, minimum, halvings + 1);
}

std::vector<double> pascalRow(std::size_t n) {
  std::vector<double> row{1};
  for (std::size_t k = 1; k <= n; ++k) row.push_back(row.back() * static_cast<double>(n + 1 - k) / static_cast<double>(k));
  return row;
}

}  // namespace

std::optional<double> zeroOf(const BernsteinPieces& pieces, double minimum) {
  const auto order = static_cast<std::ptrdiff_t>(pieces.degree) + 1;
  for (std::size_t k = 0; k < pieces.pieces(); ++k) {
    const auto first = pieces.coefficients.begin() + static_cast<std::ptrdiff_t>(k) * order;
    if (const auto zero = zeroOfPart({first, first + order}, pieces.breaks[k], pieces.breaks[k + 1], minimum, 0))
      return zero;
  }
  return {};
}

std::vector<double> bernsteinProduct(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t p = a.size() - 1, q = b.size() - 1;
  const std::vector<double> rowA = pascalRow(p), rowB = pascalRow(q), row = pascalRow(p + q);
  std::vector<double> result(p + q + 1, 0.0);
  for (std::size_t i = 0; i <= p; ++i)
    for (std::size_t j = 0; j <= q; ++j) result[i + j] += rowA[i] * a[i] * rowB[j] * b[j];
  for (std::size_t k = 0; k <= p + q; ++k) result[k] /= row[k];
  return result;
}

}  // namespace blossom::sweep
