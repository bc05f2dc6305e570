#include "kernel/grid/factor_grid.h"

#include <algorithm>

#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

/// Eight arrays of one row of poles: components and their v derivatives at a range of the v parameters.
void contractRow(const Vec4* poles, const BasisTable& v, const GridRange& columns, double* planes, std::size_t stride) {
  const std::size_t order = static_cast<std::size_t>(v.degree) + 1;
  for (std::size_t j = columns.begin; j < columns.end; ++j) {
    const Vec4* pole = poles + v.first[j];
    const double *n = v.value.data() + j * order, *dn = v.derivative.data() + j * order;
    Vec4 value = Vec4::Zero(), derivative = Vec4::Zero();
    for (std::size_t b = 0; b < order; ++b) {
      value += n[b] * pole[b];
      derivative += dn[b] * pole[b];
    }
    for (std::size_t c = 0; c < 4; ++c) {
      planes[c * stride + j] = value[static_cast<Eigen::Index>(c)];
      planes[(c + 4) * stride + j] = derivative[static_cast<Eigen::Index>(c)];
    }
  }
}

/// Length of an array of `count` values: whole cache lines and an odd number of them, because arrays that begin at the same
/// place modulo a power of two compete for the same few lines of the first-level cache.
std::size_t arrayLength(std::size_t count) { return ((count + 7) / 8 | 1) * 8; }

/// Taylor's formula about the middle. O(1).
CubicSpan cubicSpan(std::span<const double> knots, std::size_t span) {
  constexpr double factorials[4] = {1, 1, 2, 6};
  CubicSpan cubic;
  cubic.middle = (knots[span] + knots[span + 1]) / 2;
  double derivatives[16];
  basisDerivatives(3, knots, span, cubic.middle, 3, derivatives);
  for (std::size_t power = 0; power < 4; ++power)
    for (std::size_t row = 0; row < 4; ++row) cubic.weights[power][row] = derivatives[power * 4 + row] / factorials[power];
  return cubic;
}

}  // namespace

FactorGrid::FactorGrid(const Surface& surface, std::span<const double> us, BasisTable u, BasisTable v)
    : u_(std::move(u)), v_(std::move(v)), stride_(arrayLength(v_.size())) {
  findSpans(surface, us);
  if (u_.size() == 0) return;
  const auto [low, high] = std::minmax_element(u_.first.begin(), u_.first.end());
  firstRow_ = *low;
  rowCount_ = *high - *low + static_cast<std::size_t>(u_.degree) + 1;
  planes_.resize(rowCount_ * 8 * stride_);
  for (std::size_t i = 0; i < rowCount_; ++i)
    contractRow(&surface.pole(firstRow_ + i, 0), v_, {0, v_.size()}, planes_.data() + i * 8 * stride_, stride_);
}

/// Runs of parameters in one span that are long enough for its coefficients to be worth their cost.
void FactorGrid::findSpans(const Surface& surface, std::span<const double> us) {
  constexpr std::size_t leastRun = 12;
  spanOf_.assign(us.size(), -1);
  fromMiddle_.assign(us.size(), 0);
  if (u_.degree != 3) return;
  for (std::size_t k = 0, end = 0; k < us.size(); k = end) {
    while (end < us.size() && u_.first[end] == u_.first[k]) ++end;
    if (end - k < leastRun) continue;
    spans_.push_back(cubicSpan(surface.knotsU, u_.first[k] + 3));
    for (std::size_t i = k; i < end; ++i) {
      spanOf_[i] = static_cast<int>(spans_.size()) - 1;
      fromMiddle_[i] = us[i] - spans_.back().middle;
    }
  }
}

void FactorGrid::updateRow(const Surface& surface, std::size_t row, const GridRange& poles) {
  if (row < firstRow_ || row >= firstRow_ + rowCount_) return;
  contractRow(&surface.pole(row, 0), v_, v_.support(poles), planes_.data() + (row - firstRow_) * 8 * stride_, stride_);
}

}  // namespace blossom::sweep
