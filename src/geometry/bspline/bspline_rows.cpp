#include "geometry/bspline/bspline_rows.h"

#include <algorithm>
#include <array>

#include "geometry/bspline/bspline.h"

namespace blossom::detail {

namespace {

void applyRow(const PoleRows& rows, std::size_t i, const double* in, std::size_t stride, double* out) {
  const double* const weights = &rows.weights[i * rows.width];
  const double* const items = in + rows.first[i] * stride;
  if (stride == 4) {  // one pole an item
    Vec4 sum = Vec4::Zero();
    for (std::size_t k = 0; k < rows.width; ++k) sum += weights[k] * Eigen::Map<const Vec4>(items + k * 4);
    Eigen::Map<Vec4>(out + i * 4) = sum;
    return;
  }
  const auto length = static_cast<Eigen::Index>(stride);
  Eigen::Map<Eigen::VectorXd> sum(out + i * stride, length);
  sum.setZero();
  for (std::size_t k = 0; k < rows.width; ++k)
    if (weights[k] != 0) sum += weights[k] * Eigen::Map<const Eigen::VectorXd>(items + k * stride, length);
}

}  // namespace

void applyRows(const PoleRows& rows, const double* in, std::size_t stride, double* out) {
  for (std::size_t i = 0; i < rows.size(); ++i) applyRow(rows, i, in, stride, out);
}

void applyRows(const PoleRows& rows, const double* in, std::size_t stride, double* out, const Progress& progress) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    progress.check();
    applyRow(rows, i, in, stride, out);
  }
}

std::size_t lastKnotNotAbove(std::span<const double> knots, double t) {
  return static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin()) - 1;
}

void raiseBlossom(std::span<const double> knots, std::size_t last, int level, double argument, double share,
                  const double* weights, double* next, std::size_t stride) {
  for (int o = 0; o < level; ++o) {
    const double weight = weights[static_cast<std::size_t>(o) * stride];
    if (weight == 0) continue;  // such a pole may lie outside the knot vector
    const std::size_t i = last + 1 + static_cast<std::size_t>(o) - static_cast<std::size_t>(level);
    const double low = knots[i], high = knots[i + static_cast<std::size_t>(level)];
    const double part = share * weight / (high - low);
    next[static_cast<std::size_t>(o) * stride] += part * (high - argument);
    next[static_cast<std::size_t>(o + 1) * stride] += part * (argument - low);
  }
}

namespace {

using WeightRow = std::array<double, kMaximumDegree + 2>;

/// Stores the weights of the poles last - degree .. last as row i. Poles outside the knot vector have weight 0 and are cut
/// off.
void storeRow(PoleRows& rows, std::size_t i, std::size_t last, std::size_t poles, const WeightRow& weights) {
  const auto width = static_cast<std::ptrdiff_t>(rows.width);
  const std::ptrdiff_t wanted = static_cast<std::ptrdiff_t>(last) + 1 - width;
  const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(wanted, 0, static_cast<std::ptrdiff_t>(poles) - width);
  rows.first[i] = static_cast<std::size_t>(first);
  for (std::ptrdiff_t k = 0; k < width; ++k) {
    const std::ptrdiff_t source = first + k - wanted;
    rows.weights[i * rows.width + static_cast<std::size_t>(k)] = source >= 0 && source < width ? weights[source] : 0.0;
  }
}

PoleRows emptyRows(std::size_t count, std::size_t width) {
  PoleRows rows;
  rows.width = width;
  rows.first.resize(count);
  rows.weights.resize(count * width);
  return rows;
}

}  // namespace

PoleRows refinementRows(int degree, std::span<const double> from, std::span<const double> to) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  PoleRows rows = emptyRows(to.size() - order, order);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t last = lastKnotNotAbove(from, to[i]);
    WeightRow weights{}, next;
    weights[0] = 1;
    for (int level = 1; level <= degree; ++level) {
      std::fill_n(next.begin(), level + 1, 0.0);
      raiseBlossom(from, last, level, to[i + static_cast<std::size_t>(level)], 1, weights.data(), next.data());
      std::copy_n(next.begin(), level + 1, weights.begin());
    }
    storeRow(rows, i, last, from.size() - order, weights);
  }
  return rows;
}

PoleRows elevationRows(int degree, std::span<const double> from, int times, std::span<const double> to) {
  const int raised = degree + times;
  const auto order = static_cast<std::size_t>(degree) + 1;
  PoleRows rows = emptyRows(to.size() - static_cast<std::size_t>(raised) - 1, order);
  // levels[a] averages the blossoms over all choices of `a` of the arguments seen so far
  std::vector<WeightRow> levels(order), next(order);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t last = lastKnotNotAbove(from, to[i]);
    for (WeightRow& level : levels) level.fill(0);
    levels[0][0] = 1;
    for (int m = 1; m <= raised; ++m) {
      const double argument = to[i + static_cast<std::size_t>(m)];
      for (int a = std::max(0, m - times); a <= std::min(m, degree); ++a) {
        next[a].fill(0);
        const double taken = static_cast<double>(a) / m;
        if (a > 0) raiseBlossom(from, last, a, argument, taken, levels[a - 1].data(), next[a].data());
        if (a < m)
          for (int o = 0; o <= a; ++o) next[a][o] += (1 - taken) * levels[a][o];
      }
      levels.swap(next);
    }
    storeRow(rows, i, last, from.size() - order, levels[degree]);
  }
  return rows;
}

}  // namespace blossom::detail
